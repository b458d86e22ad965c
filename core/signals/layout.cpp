#include "signals/layout.h"

#include <algorithm>
#include <cstring>
#include <functional>

namespace trundle {

namespace {

constexpr std::uint32_t kGap = 0xffffffffu;

/// Continues a hash with a number, each bit of which may change half of the bits.
std::uint64_t hashNumber(std::uint64_t value, std::uint64_t start) {
    const std::uint64_t h = (start ^ value) * 0x9e3779b97f4a7c15ull; // odd, with as many ones as zeros
    return h ^ (h >> 32);
}

/// Continues a hash with a text and its length, so that "ab","c" differs from "a","bc": eight characters at a time, as the names of all
/// signals of a large world are long.
std::uint64_t hashText(std::string_view text, std::uint64_t start) {
    std::uint64_t h = hashNumber(text.size(), start);
    for (; !text.empty(); text.remove_prefix(std::min<std::size_t>(8, text.size()))) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data(), std::min<std::size_t>(8, text.size()));
        h = hashNumber(word, h);
    }
    return h;
}

} // namespace

void SignalLayout::beginRobot(std::string name) { m_images.push_back({std::move(name), m_slots, 0}); }

std::uint32_t SignalLayout::add(std::string path, std::string unit, SignalType type, SignalDirection direction,
                                std::uint32_t count) {
    const std::uint32_t offset = m_slots;
    if (2 * (m_entries.size() + 1) > m_index.size()) enlargeIndex();
    std::uint32_t& place = m_index[placeOf(path)];
    if (place == kGap) place = static_cast<std::uint32_t>(m_entries.size()); // of two equal paths the first is kept
    m_entries.push_back({std::move(path), std::move(unit), type, direction, offset, count});
    m_slots += count;
    if (!m_images.empty()) m_images.back().count += count;
    return offset;
}

const SignalEntry* SignalLayout::find(std::string_view path) const {
    if (m_index.empty()) return nullptr;
    const std::uint32_t index = m_index[placeOf(path)];
    return index == kGap ? nullptr : &m_entries[index];
}

/// Where the path is in the index, or the gap where it would be: from its hash on, one place after the other.
std::size_t SignalLayout::placeOf(std::string_view path) const {
    const std::size_t mask = m_index.size() - 1;
    const std::hash<std::string_view> hashOf;
    std::size_t at = hashOf(path) & mask;
    while (m_index[at] != kGap && m_entries[m_index[at]].path != path) at = (at + 1) & mask;
    return at;
}

void SignalLayout::enlargeIndex() {
    m_index.assign(std::max<std::size_t>(16, 2 * m_index.size()), kGap);
    for (std::uint32_t i = 0; i < m_entries.size(); ++i)
        if (std::uint32_t& place = m_index[placeOf(m_entries[i].path)]; place == kGap) place = i;
}

std::uint64_t SignalLayout::hash() const {
    std::uint64_t h = hashNumber(m_entries.size(), 0xcbf29ce484222325ull);
    for (const SignalEntry& e : m_entries) {
        h = hashText(e.unit, hashText(e.path, h));
        h = hashNumber(static_cast<std::uint64_t>(e.type), h);
        h = hashNumber(static_cast<std::uint64_t>(e.direction), h);
        h = hashNumber(e.offset, h);
        h = hashNumber(e.count, h);
    }
    for (const ImageSpan& image : m_images) h = hashNumber(image.count, hashNumber(image.offset, hashText(image.robot, h)));
    return h;
}

} // namespace trundle
