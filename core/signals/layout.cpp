#include "signals/layout.h"

#include <cstring>

#include "base/rng.h"

namespace trundle {

namespace {

/// Continues an FNV hash with a number, independently of the machine's byte order.
std::uint64_t hashNumber(std::uint64_t value, std::uint64_t start) {
    char bytes[8];
    for (int i = 0; i < 8; ++i) bytes[i] = static_cast<char>(value >> (8 * i));
    return fnv1a64({bytes, 8}, start);
}

/// Continues an FNV hash with a text and its length, so that "ab","c" differs from "a","bc".
std::uint64_t hashText(std::string_view text, std::uint64_t start) { return fnv1a64(text, hashNumber(text.size(), start)); }

} // namespace

void SignalLayout::beginRobot(std::string name) { m_images.push_back({std::move(name), m_slots, 0}); }

std::uint32_t SignalLayout::add(std::string path, std::string unit, SignalType type, SignalDirection direction,
                                std::uint32_t count) {
    const std::uint32_t offset = m_slots;
    m_byPath.emplace(path, static_cast<std::uint32_t>(m_entries.size())); // of two equal paths the first is kept
    m_entries.push_back({std::move(path), std::move(unit), type, direction, offset, count});
    m_slots += count;
    if (!m_images.empty()) m_images.back().count += count;
    return offset;
}

const SignalEntry* SignalLayout::find(std::string_view path) const {
    const auto it = m_byPath.find(path);
    return it == m_byPath.end() ? nullptr : &m_entries[it->second];
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
