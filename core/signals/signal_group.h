#pragma once
// The signals of one robot by their names, the same for all robots that are equal.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

enum class SignalType : std::uint32_t { Real = 1, Integer = 2, Boolean = 3 };
/// Truth: ground truth, available only in simulation; controllers read it only through groundTruth ports.
enum class SignalDirection : std::uint32_t { Output = 1, Command = 2, Truth = 3 };

/// Indices by name, in a table with gaps; for lookup only.
class NameIndex {
public:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    /// The index with this name; `nameOf(index)` is its name.
    template <class NameOf> [[nodiscard]] std::uint32_t find(std::string_view name, NameOf nameOf) const {
        return m_places.empty() ? kNone : m_places[placeOf(name, nameOf)];
    }
    /// Adds the next index, which is `m_count`. Of two with one name the first is kept.
    template <class NameOf> void add(std::string_view name, NameOf nameOf) {
        if (2 * (m_count + std::size_t{1}) > m_places.size()) enlarge(nameOf);
        if (std::uint32_t& place = m_places[placeOf(name, nameOf)]; place == kNone) place = m_count;
        ++m_count;
    }

private:
    /// Where the name is, or the gap where it would be: from its hash on, one place after the other.
    template <class NameOf> [[nodiscard]] std::size_t placeOf(std::string_view name, NameOf nameOf) const {
        const std::size_t mask = m_places.size() - 1;
        std::size_t at = std::hash<std::string_view>()(name) & mask;
        while (m_places[at] != kNone && nameOf(m_places[at]) != name) at = (at + 1) & mask;
        return at;
    }
    template <class NameOf> void enlarge(NameOf nameOf) {
        m_places.assign(m_places.empty() ? 16 : 2 * m_places.size(), kNone);
        for (std::uint32_t i = 0; i < m_count; ++i)
            if (std::uint32_t& place = m_places[placeOf(nameOf(i), nameOf)]; place == kNone) place = i;
    }

    std::vector<std::uint32_t> m_places;
    std::uint32_t m_count = 0;
};

class SignalGroup {
public:
    /// As SignalEntry, without the name of the robot and from its first slot on.
    struct Item {
        std::string name, unit;
        SignalType type = SignalType::Real;
        SignalDirection direction = SignalDirection::Output;
        std::uint32_t offset = 0, count = 1;
    };
    void add(Item item);
    /// nullptr: none.
    [[nodiscard]] const Item* find(std::string_view name) const;
    [[nodiscard]] const std::vector<Item>& items() const { return m_items; }
    [[nodiscard]] std::uint64_t hash() const;

private:
    std::vector<Item> m_items;
    NameIndex m_byName;
};

/// Continues a hash with a number, each bit of which may change half of the bits.
[[nodiscard]] std::uint64_t hashNumber(std::uint64_t value, std::uint64_t start);
/// Continues a hash with a text and its length, so that "ab","c" differs from "a","bc".
[[nodiscard]] std::uint64_t hashText(std::string_view text, std::uint64_t start);

} // namespace trundle
