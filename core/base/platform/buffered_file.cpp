#include "base/platform/buffered_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trundle {
namespace {

constexpr std::size_t kBufferBytes = 32 * 1024;
constexpr int kMostWaits = 100; // of a millisecond each

// Handlers of the system take no arguments of ours.
std::atomic_flag s_listBusy;
BufferedFile* s_first = nullptr; // of the open files

/// Held for moments only. Whoever writes out for a program that ends never lets go: the others wait here for that end.
class Hold {
public:
    explicit Hold(std::atomic_flag& flag) : m_flag(flag) {
        while (m_flag.test_and_set(std::memory_order_acquire)) nap();
    }
    ~Hold() { m_flag.clear(std::memory_order_release); }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

    static void nap() noexcept {
        const timespec moment{0, 1'000'000};
        nanosleep(&moment, nullptr);
    }
    /// Only this long, and for good. False: its owner will not let go, for it is the thread that we interrupted.
    static bool takeForGood(std::atomic_flag& flag) noexcept {
        for (int i = 0; i < kMostWaits; ++i) {
            if (!flag.test_and_set(std::memory_order_acquire)) return true;
            nap();
        }
        return false;
    }

private:
    std::atomic_flag& m_flag;
};

} // namespace

BufferedFile::BufferedFile(std::FILE* file) : m_buffer(std::make_unique<char[]>(kBufferBytes)) {
    m_file = ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 3);
    if (m_file < 0) m_error = errno;
    std::fclose(file);
    struct stat own {};
    if (m_file >= 0 && ::fstat(m_file, &own) == 0) {
        m_device = own.st_dev;
        m_inode = own.st_ino;
    }
    const Hold hold(s_listBusy);
    m_next = s_first;
    if (m_next) m_next->m_previous = this;
    s_first = this;
}

BufferedFile::~BufferedFile() { (void)close(); }

bool BufferedFile::isStillOurs() const noexcept {
    struct stat now {};
    return ::fstat(m_file, &now) == 0 && now.st_dev == m_device && now.st_ino == m_inode;
}

/// By place, so that bytes which are written twice stand there once.
int BufferedFile::writeOut() noexcept {
    if (m_error || m_held == 0) return m_error;
    if (!isStillOurs()) return m_error = EBADF;
    std::size_t done = 0;
    while (done < m_held) {
        const ssize_t part = ::pwrite(m_file, m_buffer.get() + done, m_held - done, m_written + static_cast<std::int64_t>(done));
        if (part < 0 && errno == EINTR) continue;
        if (part <= 0) return m_error = part < 0 ? errno : EIO;
        done += static_cast<std::size_t>(part);
    }
    m_written += static_cast<std::int64_t>(m_held);
    m_held = 0;
    return 0;
}

int BufferedFile::write(std::string_view bytes) {
    const Hold hold(m_busy);
    if (m_file < 0) return m_error;
    while (!bytes.empty() && !m_error) {
        const std::size_t part = std::min(bytes.size(), kBufferBytes - m_held);
        std::memcpy(m_buffer.get() + m_held, bytes.data(), part);
        m_held += part;
        bytes.remove_prefix(part);
        if (m_held == kBufferBytes) (void)writeOut();
    }
    return m_error;
}

int BufferedFile::flush() {
    const Hold hold(m_busy);
    return m_file < 0 ? m_error : writeOut();
}

int BufferedFile::close() {
    if (m_file < 0 && !m_buffer) return m_error;
    {
        const Hold hold(s_listBusy);
        if (m_next) m_next->m_previous = m_previous;
        if (m_previous) m_previous->m_next = m_next;
        else s_first = m_next;
        m_next = m_previous = nullptr;
    }
    const Hold hold(m_busy);
    (void)writeOut();
    if (m_file >= 0 && isStillOurs() && ::close(m_file) != 0 && !m_error) m_error = errno;
    m_file = -1;
    m_buffer.reset(); // a run may write thousands of pictures
    return m_error;
}

void BufferedFile::writeOutAll() noexcept {
    if (!Hold::takeForGood(s_listBusy)) return;
    for (BufferedFile* file = s_first; file; file = file->m_next)
        if (Hold::takeForGood(file->m_busy)) (void)file->writeOut();
}

} // namespace trundle
