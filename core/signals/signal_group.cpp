#include "signals/signal_group.h"

#include <algorithm>
#include <cstring>

namespace trundle {

void SignalGroup::add(Item item) {
    m_items.push_back(std::move(item));
    m_byName.add(m_items.back().name, [this](std::uint32_t i) -> std::string_view { return m_items[i].name; });
}

const SignalGroup::Item* SignalGroup::find(std::string_view name) const {
    const std::uint32_t index = m_byName.find(name, [this](std::uint32_t i) -> std::string_view { return m_items[i].name; });
    return index == NameIndex::kNone ? nullptr : &m_items[index];
}

std::uint64_t SignalGroup::hash() const {
    std::uint64_t h = hashNumber(m_items.size(), 0xcbf29ce484222325ull);
    for (const Item& item : m_items) {
        h = hashText(item.unit, hashText(item.name, h));
        h = hashNumber(static_cast<std::uint64_t>(item.type), h);
        h = hashNumber(static_cast<std::uint64_t>(item.direction), h);
        h = hashNumber(item.count, hashNumber(item.offset, h));
    }
    return h;
}

std::uint64_t hashNumber(std::uint64_t value, std::uint64_t start) {
    const std::uint64_t h = (start ^ value) * 0x9e3779b97f4a7c15ull; // odd, with as many ones as zeros
    return h ^ (h >> 32);
}

/// Eight characters at a time.
std::uint64_t hashText(std::string_view text, std::uint64_t start) {
    std::uint64_t h = hashNumber(text.size(), start);
    for (; !text.empty(); text.remove_prefix(std::min<std::size_t>(8, text.size()))) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data(), std::min<std::size_t>(8, text.size()));
        h = hashNumber(word, h);
    }
    return h;
}

} // namespace trundle
