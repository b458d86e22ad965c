#pragma once
// The messages of the remote control: a length-prefixed JSON object, with bytes behind it.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace trundle {

/// A message. On the wire: the size of `json` and that of `bytes`, each as 4 bytes, little-endian; then both.
struct Frame {
    std::string json;  ///< an object, UTF-8
    std::string bytes; ///< for example signals as doubles, or pixels
};

struct FrameLimits {
    std::uint32_t json = 0, bytes = 0; ///< largest sizes
};

/// Appends the bytes of a frame to `out`.
void appendFrame(std::string& out, std::string_view json, std::string_view bytes = {});

/// Cuts a stream of bytes into frames.
class FrameReader {
public:
    explicit FrameReader(FrameLimits limits) : m_limits(limits) {}
    void setLimits(FrameLimits limits) { m_limits = limits; }

    void add(std::span<const char> bytes) { m_received.append(bytes.data(), bytes.size()); }
    /// The next complete frame; none if it is not complete. Fails if it is larger than the limits, and then always: where the next
    /// frame begins is unknown.
    [[nodiscard]] Result<std::optional<Frame>> next();
    /// Whether next() would give a frame or fail.
    [[nodiscard]] bool hasNext() const;
    /// Bytes of a frame that has begun.
    [[nodiscard]] std::size_t waiting() const { return m_received.size() - m_read; }

private:
    [[nodiscard]] std::uint32_t number(std::size_t at) const;
    FrameLimits m_limits;
    std::string m_received;
    std::size_t m_read = 0; ///< bytes at its start that are done
};

} // namespace trundle
