#include "remote/frame.h"

namespace trundle {
namespace {

constexpr std::size_t kHead = 8; ///< bytes of both sizes

void appendNumber(std::string& out, std::uint32_t number) {
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(number >> shift & 0xff);
}

} // namespace

void appendFrame(std::string& out, std::string_view json, std::string_view bytes) {
    appendNumber(out, static_cast<std::uint32_t>(json.size()));
    appendNumber(out, static_cast<std::uint32_t>(bytes.size()));
    out += json;
    out += bytes;
}

std::uint32_t FrameReader::number(std::size_t at) const {
    std::uint32_t number = 0;
    for (std::size_t i = 4; i-- > 0;) number = number << 8 | static_cast<std::uint8_t>(m_received[m_read + at + i]);
    return number;
}

bool FrameReader::hasNext() const {
    if (waiting() < kHead) return false;
    const std::uint64_t json = number(0), bytes = number(4);
    return json > m_limits.json || bytes > m_limits.bytes || waiting() >= kHead + json + bytes;
}

Result<std::optional<Frame>> FrameReader::next() {
    if (!hasNext()) return std::optional<Frame>();
    const std::size_t json = number(0), bytes = number(4);
    if (json > m_limits.json || bytes > m_limits.bytes)
        return Error{Code::SystemRefused, "a message of " + std::to_string(json) + " bytes of JSON and " + std::to_string(bytes) +
                                              " other bytes is too large; at most " + std::to_string(m_limits.json) + " and " +
                                              std::to_string(m_limits.bytes) +
                                              " are accepted here. Does the other end speak this protocol?"};
    Frame frame{m_received.substr(m_read + kHead, json), m_received.substr(m_read + kHead + json, bytes)};
    m_read += kHead + json + bytes;
    if (m_read == m_received.size() || m_read > (64u << 10)) { // keeps what is cut off amortized
        m_received.erase(0, m_read);
        m_read = 0;
    }
    return std::optional(std::move(frame));
}

} // namespace trundle
