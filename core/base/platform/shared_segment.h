#pragma once
#include <cstddef>
#include <memory>
#include <utility>

#include "base/result.h"

namespace trundle {

/// Memory that two processes share: a memfd and its mapping in this process.
class SharedSegment {
public:
    /// New memory of zeros. Its size is fixed once it is known: a peer cannot shrink it. 0 bytes: see resize().
    [[nodiscard]] static Result<SharedSegment> create(const char* name, std::size_t bytes);
    /// Maps the whole of an inherited descriptor, which stays open.
    [[nodiscard]] static Result<SharedSegment> map(int descriptor, bool writable);

    SharedSegment() = default;
    SharedSegment(SharedSegment&& other) noexcept { *this = std::move(other); }
    SharedSegment& operator=(SharedSegment&& other) noexcept;
    ~SharedSegment();

    /// Gives a new segment of 0 bytes its size. Call once.
    [[nodiscard]] Status resize(std::size_t bytes);
    [[nodiscard]] void* data() const { return m_data; }
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }
    [[nodiscard]] int descriptor() const { return m_file; }
    /// A second descriptor of a created segment, through which it can be read but never be written. -1: the system refuses.
    [[nodiscard]] int readOnlyDescriptor();

private:
    int m_file = -1; ///< own; -1: of a mapped one
    int m_readOnly = -1;
    void* m_data = nullptr;
    std::size_t m_bytes = 0;
};

} // namespace trundle
