#include "base/platform/socket.h"

#include <cerrno>
#include <cstring>
#include <vector>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace trundle {
namespace {

constexpr int kBacklog = 16;

struct Address {
    sockaddr_storage bytes{};
    socklen_t size = 0;
    bool loopback = false;
};

std::optional<Address> addressOf(const std::string& text, std::uint16_t port) {
    const std::string numeric = text == "localhost" ? "127.0.0.1" : text;
    Address address;
    sockaddr_in v4{};
    sockaddr_in6 v6{};
    if (inet_pton(AF_INET, numeric.c_str(), &v4.sin_addr) == 1) {
        v4.sin_family = AF_INET;
        v4.sin_port = htons(port);
        std::memcpy(&address.bytes, &v4, sizeof v4);
        address.size = sizeof v4;
        address.loopback = (ntohl(v4.sin_addr.s_addr) >> 24) == 127;
        return address;
    }
    if (inet_pton(AF_INET6, numeric.c_str(), &v6.sin6_addr) != 1) return std::nullopt;
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(port);
    std::memcpy(&address.bytes, &v6, sizeof v6);
    address.size = sizeof v6;
    address.loopback = IN6_IS_ADDR_LOOPBACK(&v6.sin6_addr);
    return address;
}

void sendAtOnce(int file) { // fails for a socket that is not TCP, which does not matter
    const int on = 1;
    (void)setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

Error systemError(const std::string& what) { return {Code::SystemRefused, what + ": " + std::strerror(errno)}; }

} // namespace

Result<Socket> Socket::listen(const std::string& address, std::uint16_t port) {
    const std::string what = "cannot listen at " + address + ":" + std::to_string(port);
    const std::optional<Address> at = addressOf(address, port);
    if (!at) return Error{Code::SystemRefused, what + ": it is not a numeric address"};
    Socket socket(::socket(at->bytes.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!socket.isOpen()) return systemError(what);
    const int on = 1;
    (void)setsockopt(socket.m_file, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (bind(socket.m_file, reinterpret_cast<const sockaddr*>(&at->bytes), at->size) != 0 || ::listen(socket.m_file, kBacklog) != 0)
        return systemError(what);
    return socket;
}

Result<Socket> Socket::connect(const std::string& address, std::uint16_t port, double seconds) {
    const std::string what = "cannot connect to " + address + ":" + std::to_string(port);
    const std::optional<Address> at = addressOf(address, port);
    if (!at) return Error{Code::SystemRefused, what + ": it is not a numeric address"};
    Socket socket(::socket(at->bytes.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!socket.isOpen()) return systemError(what);
    int fault = 0;
    if (::connect(socket.m_file, reinterpret_cast<const sockaddr*>(&at->bytes), at->size) != 0 && errno != EINPROGRESS)
        return systemError(what);
    pollfd wait{socket.m_file, POLLOUT, 0};
    if (poll(&wait, 1, static_cast<int>(1000 * seconds)) <= 0) fault = ETIMEDOUT;
    socklen_t size = sizeof fault;
    if (fault == 0 && getsockopt(socket.m_file, SOL_SOCKET, SO_ERROR, &fault, &size) != 0) fault = errno;
    if (fault != 0) {
        errno = fault;
        return systemError(what);
    }
    sendAtOnce(socket.m_file);
    return socket;
}

Result<Socket> Socket::duplicate() const {
    const int copy = fcntl(m_file, F_DUPFD_CLOEXEC, 0);
    if (copy < 0) return systemError("cannot use a socket twice");
    return Socket(copy);
}

Result<Socket> Socket::adopt(int descriptor) {
    int type = 0;
    socklen_t size = sizeof type;
    sockaddr_storage peer{};
    socklen_t peerSize = sizeof peer;
    const bool isStream = getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) == 0 && type == SOCK_STREAM;
    if (!isStream || getpeername(descriptor, reinterpret_cast<sockaddr*>(&peer), &peerSize) != 0)
        return Error{Code::SystemRefused, "descriptor " + std::to_string(descriptor) + " is not a connected stream socket"};
    const int flags = fcntl(descriptor, F_GETFL);
    if (fcntl(descriptor, F_SETFL, flags | O_NONBLOCK) != 0 || fcntl(descriptor, F_SETFD, FD_CLOEXEC) != 0)
        return systemError("cannot use descriptor " + std::to_string(descriptor));
    sendAtOnce(descriptor);
    return Socket(descriptor);
}

Result<std::pair<Socket, Socket>> Socket::pair() {
    int files[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, files) != 0) return systemError("cannot make sockets");
    return std::pair(Socket(files[0]), Socket(files[1]));
}

Socket& Socket::operator=(Socket&& other) noexcept {
    if (this != &other) {
        close();
        m_file = std::exchange(other.m_file, -1);
    }
    return *this;
}

std::optional<Socket> Socket::accept() {
    const int file = accept4(m_file, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (file < 0) return std::nullopt;
    sendAtOnce(file);
    return Socket(file);
}

std::optional<std::size_t> Socket::read(std::span<char> bytes) {
    const ssize_t got = recv(m_file, bytes.data(), bytes.size(), 0);
    if (got > 0) return static_cast<std::size_t>(got);
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return 0;
    return std::nullopt;
}

std::optional<std::size_t> Socket::write(std::string_view bytes) {
    const ssize_t sent = send(m_file, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) return static_cast<std::size_t>(sent);
    if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) return 0;
    return std::nullopt;
}

std::uint16_t Socket::port() const {
    sockaddr_storage bytes{};
    socklen_t size = sizeof bytes;
    if (getsockname(m_file, reinterpret_cast<sockaddr*>(&bytes), &size) != 0) return 0;
    sockaddr_in v4{};
    sockaddr_in6 v6{};
    std::memcpy(&v4, &bytes, sizeof v4);
    std::memcpy(&v6, &bytes, sizeof v6);
    return ntohs(bytes.ss_family == AF_INET6 ? v6.sin6_port : v4.sin_port);
}

void Socket::close() {
    if (m_file >= 0) ::close(std::exchange(m_file, -1));
}

void waitForSockets(std::span<SocketWait> sockets, std::chrono::nanoseconds atMost) {
    std::vector<pollfd> polled;
    for (const SocketWait& socket : sockets)
        polled.push_back({socket.descriptor, static_cast<short>((socket.read ? POLLIN : 0) | (socket.write ? POLLOUT : 0) | POLLRDHUP), 0});
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(atMost);
    const timespec limit{static_cast<time_t>(seconds.count()), static_cast<long>((atMost - seconds).count())};
    if (ppoll(polled.data(), polled.size(), &limit, nullptr) <= 0) return;
    for (std::size_t i = 0; i < polled.size(); ++i) {
        sockets[i].hasEnded = (polled[i].revents & (POLLERR | POLLHUP | POLLNVAL | POLLRDHUP)) != 0;
        sockets[i].canRead = (polled[i].revents & POLLIN) != 0;
        sockets[i].canWrite = (polled[i].revents & POLLOUT) != 0;
    }
}

bool isLoopback(const std::string& address) {
    const std::optional<Address> at = addressOf(address, 0);
    return at && at->loopback;
}

} // namespace trundle
