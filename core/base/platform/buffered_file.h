#pragma once
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>

namespace trundle {

/// A file that is written from its start through a buffer of fixed size. What the buffer holds can be written out by the handler of a
/// crash too, on any thread: nothing that was written is lost then. Its descriptor is none of the three standard ones, whoever
/// closed those, and where somebody closed it or put another file in its place, writing fails and that file is left alone.
class BufferedFile {
public:
    /// Takes over an open file into which nothing was written.
    explicit BufferedFile(std::FILE* file);
    ~BufferedFile();
    BufferedFile(const BufferedFile&) = delete;
    BufferedFile& operator=(const BufferedFile&) = delete;

    // Each gives 0 or the number of the error. After an error nothing more is written.
    int write(std::string_view bytes);
    int flush();
    int close();
    [[nodiscard]] bool isOpen() const { return m_file >= 0; }

    /// Writes out what all of them in this process hold; they take no more bytes afterwards. For a program that ends: may be called
    /// from a signal handler, and waits for no thread longer than a moment.
    static void writeOutAll() noexcept;

private:
    [[nodiscard]] int writeOut() noexcept;
    [[nodiscard]] bool isStillOurs() const noexcept;

    int m_file = -1;
    std::uint64_t m_device = 0, m_inode = 0;
    std::unique_ptr<char[]> m_buffer;
    std::size_t m_held = 0;     ///< bytes in the buffer
    std::int64_t m_written = 0; ///< bytes in the file
    int m_error = 0;
    std::atomic_flag m_busy; ///< held while the above change
    BufferedFile *m_next = nullptr, *m_previous = nullptr;
};

} // namespace trundle
