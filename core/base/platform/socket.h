#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"

namespace trundle {

/// An owned stream socket. No call of it blocks.
class Socket {
public:
    /// Listens at a numeric IPv4 or IPv6 address, or "localhost". Port 0: a free one, see port().
    [[nodiscard]] static Result<Socket> listen(const std::string& address, std::uint16_t port);
    /// Connects to a numeric address, or "localhost", where something listens. Waits at most `seconds`.
    [[nodiscard]] static Result<Socket> connect(const std::string& address, std::uint16_t port, double seconds = 10);
    /// Takes over a connected stream socket that this process inherited. Fails for any other descriptor.
    [[nodiscard]] static Result<Socket> adopt(int descriptor);
    /// Two sockets connected with each other.
    [[nodiscard]] static Result<std::pair<Socket, Socket>> pair();
    /// Another descriptor of the same socket.
    [[nodiscard]] Result<Socket> duplicate() const;
    Socket() = default;
    Socket(Socket&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}
    Socket& operator=(Socket&& other) noexcept;
    ~Socket() { close(); }

    /// The next waiting connection of a listening socket; empty if no connection waits.
    [[nodiscard]] std::optional<Socket> accept();
    /// The number of bytes that were available, at most all of `bytes`; 0 if there are none now. None: the other end has closed it.
    [[nodiscard]] std::optional<std::size_t> read(std::span<char> bytes);
    /// The number of bytes that the system accepted. None: the other end has closed it.
    [[nodiscard]] std::optional<std::size_t> write(std::string_view bytes);
    /// Of a listening socket.
    [[nodiscard]] std::uint16_t port() const;
    [[nodiscard]] int descriptor() const { return m_file; }
    [[nodiscard]] bool isOpen() const { return m_file >= 0; }
    void close();

private:
    explicit Socket(int file) : m_file(file) {}
    int m_file = -1;
};

/// What is awaited of a socket, and what has become possible.
struct SocketWait {
    int descriptor = -1;
    bool read = false, write = false;
    bool canRead = false, canWrite = false;
    bool hasEnded = false; ///< the other end sends no more; what it sent before can still be read
};

/// Waits until one of them is ready, the time is over, or a signal arrives.
void waitForSockets(std::span<SocketWait> sockets, std::chrono::nanoseconds atMost);

/// Whether a numeric address, or "localhost", can be reached from this machine alone.
[[nodiscard]] bool isLoopback(const std::string& address);

} // namespace trundle
