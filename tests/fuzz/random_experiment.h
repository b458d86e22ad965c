#pragma once
// Generates experiments that the schema allows from arbitrary bytes: every choice and value is decoded from them, so a
// fuzzer can guide it and a seed reproduces it. Values stay in the range their kind describes; whether such a robot makes sense is
// what the text is to find out.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "schema/registry.h"

namespace trundle::fuzz {

/// Decisions from bytes. When they run out every choice is 0, so texts end.
class Choices {
public:
    explicit Choices(std::span<const std::uint8_t> bytes) : m_bytes(bytes) {}

    /// 0 .. count-1
    std::uint32_t pick(std::uint32_t count);
    bool chance(std::uint32_t inSixteen) { return pick(16) < inSixteen; }
    [[nodiscard]] bool spent() const { return m_next >= m_bytes.size(); }

private:
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_next = 0;
};

/// A whole experiment of one to a few robots, statics and surfaces using the kinds of `registry`.
[[nodiscard]] std::string randomExperiment(Choices& choices, const Registry& registry);

} // namespace trundle::fuzz
