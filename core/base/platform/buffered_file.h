#pragma once
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>

namespace trundle {

/// A file written from its start through a buffer of fixed size. A crash handler can flush the buffer on any thread, so no
/// written bytes are lost. The descriptor is never 0, 1 or 2, even where those were closed. If other code closes the descriptor
/// or reuses its number for another file, writing fails and that file is left unchanged.
class BufferedFile {
public:
    /// Takes ownership of an open file to which nothing has been written.
    explicit BufferedFile(std::FILE* file);
    ~BufferedFile();
    BufferedFile(const BufferedFile&) = delete;
    BufferedFile& operator=(const BufferedFile&) = delete;

    // Each returns 0 or an errno. After an error nothing more is written.
    int write(std::string_view bytes);
    int flush();
    int close();
    [[nodiscard]] bool isOpen() const { return m_file >= 0; }

    /// Flushes all open files of this process; afterwards they accept no more bytes. For a process that is about to end:
    /// async-signal-safe, and waits for other threads only briefly.
    static void writeOutAll() noexcept;

private:
    [[nodiscard]] int writeOut() noexcept;
    [[nodiscard]] bool isUnreplaced() const noexcept;

    int m_file = -1;
    std::uint64_t m_device = 0, m_inode = 0;
    std::unique_ptr<char[]> m_buffer;
    std::size_t m_held = 0;     ///< bytes in the buffer
    std::int64_t m_written = 0; ///< bytes written to the file
    int m_error = 0;
    std::atomic_flag m_busy; ///< held while the members above change
    BufferedFile *m_next = nullptr, *m_previous = nullptr;
};

} // namespace trundle
