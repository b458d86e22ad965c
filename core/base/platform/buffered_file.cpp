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
constexpr int kMaxWaits = 100; // 1 ms each

// Global, because a signal handler receives no arguments of ours.
std::atomic_flag s_listBusy;
BufferedFile* s_first = nullptr; // list of the open files

/// Held only briefly, except by writeOutAll(), which never releases it: the process is about to end and other threads wait here.
class FileListLock {
public:
    explicit FileListLock(std::atomic_flag& flag) : m_flag(flag) {
        while (m_flag.test_and_set(std::memory_order_acquire)) sleepBriefly();
    }
    ~FileListLock() { m_flag.clear(std::memory_order_release); }
    FileListLock(const FileListLock&) = delete;
    FileListLock& operator=(const FileListLock&) = delete;

    static void sleepBriefly() noexcept {
        const timespec moment{0, 1'000'000};
        nanosleep(&moment, nullptr);
    }
    /// Locks without ever unlocking, with a bounded wait. False if the owner cannot release it because it is the interrupted
    /// thread itself.
    static bool lockForever(std::atomic_flag& flag) noexcept {
        for (int i = 0; i < kMaxWaits; ++i) {
            if (!flag.test_and_set(std::memory_order_acquire)) return true;
            sleepBriefly();
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
    const FileListLock hold(s_listBusy);
    m_next = s_first;
    if (m_next) m_next->m_previous = this;
    s_first = this;
}

BufferedFile::~BufferedFile() { (void)close(); }

bool BufferedFile::isUnreplaced() const noexcept {
    struct stat now {};
    return ::fstat(m_file, &now) == 0 && now.st_dev == m_device && now.st_ino == m_inode;
}

/// Uses pwrite with explicit offsets, so that bytes written twice appear once in the file.
int BufferedFile::writeOut() noexcept {
    if (m_error || m_held == 0) return m_error;
    if (!isUnreplaced()) return m_error = EBADF;
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
    const FileListLock hold(m_busy);
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
    const FileListLock hold(m_busy);
    return m_file < 0 ? m_error : writeOut();
}

int BufferedFile::close() {
    if (m_file < 0 && !m_buffer) return m_error;
    {
        const FileListLock hold(s_listBusy);
        if (m_next) m_next->m_previous = m_previous;
        if (m_previous) m_previous->m_next = m_next;
        else s_first = m_next;
        m_next = m_previous = nullptr;
    }
    const FileListLock hold(m_busy);
    (void)writeOut();
    if (m_file >= 0 && isUnreplaced() && ::close(m_file) != 0 && !m_error) m_error = errno;
    m_file = -1;
    m_buffer.reset(); // frees memory early: a run may write thousands of pictures
    return m_error;
}

void BufferedFile::writeOutAll() noexcept {
    if (!FileListLock::lockForever(s_listBusy)) return;
    for (BufferedFile* file = s_first; file; file = file->m_next)
        if (FileListLock::lockForever(file->m_busy)) (void)file->writeOut();
}

} // namespace trundle
