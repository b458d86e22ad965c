#pragma once
// The layout of all signals of a world in one flat block, versioned and self-describing.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "signals/signal_group.h"

namespace trundle {

/// `count` slots of 8-byte doubles starting at slot `offset`. Integers and booleans are stored as doubles, exact up to 2^53.
struct SignalEntry {
    std::string path; ///< "robot0/leftEncoder/count"
    std::string unit; ///< SI
    SignalType type = SignalType::Real;
    SignalDirection direction = SignalDirection::Output;
    std::uint32_t offset = 0;
    std::uint32_t count = 1;
};

/// The contiguous slots of one robot: its signal image.
struct ImageSpan {
    std::string robot;
    std::uint32_t offset = 0;
    std::uint32_t count = 0;
    std::shared_ptr<SignalGroup> group = std::make_shared<SignalGroup>(); ///< equal robots share one
};

class SignalLayout {
public:
    /// Entries of consecutive images, made when they are read.
    class Range;

    /// Begins a robot's image; all following add() calls belong to it.
    void beginRobot(std::string name);
    /// Adds an image with the signals of the image `equal`.
    void repeatRobot(std::string name, std::size_t equal);
    /// `name`: without that of the robot. Returns the first slot.
    std::uint32_t add(std::string name, std::string unit, SignalType type, SignalDirection direction, std::uint32_t count = 1);

    [[nodiscard]] std::optional<SignalEntry> find(std::string_view path) const;
    [[nodiscard]] Range entries() const;
    /// Those of one robot; none if it has no image.
    [[nodiscard]] Range entriesOf(std::string_view robot) const;
    /// nullptr: the robot has none.
    [[nodiscard]] const ImageSpan* imageOf(std::string_view robot) const;
    [[nodiscard]] const std::vector<ImageSpan>& images() const { return m_images; }
    [[nodiscard]] std::uint32_t slotCount() const { return m_slots; }
    /// Over all entries: two blocks with the same hash have the same layout. Differs between machines of different byte order.
    [[nodiscard]] std::uint64_t hash() const;

private:
    [[nodiscard]] SignalEntry entryOf(const ImageSpan& image, const SignalGroup::Item& item) const;

    std::vector<ImageSpan> m_images;
    NameIndex m_byRobot; ///< of m_images
    std::uint32_t m_slots = 0;
};

class SignalLayout::Range {
public:
    class Iterator {
    public:
        using value_type = SignalEntry;
        using difference_type = std::ptrdiff_t;

        Iterator() = default;
        [[nodiscard]] SignalEntry operator*() const {
            const ImageSpan& image = m_layout->m_images[m_image];
            return m_layout->entryOf(image, image.group->items()[m_item]);
        }
        Iterator& operator++() {
            ++m_item;
            skipEmpty();
            return *this;
        }
        void operator++(int) { ++*this; }
        [[nodiscard]] bool operator==(const Iterator& other) const { return m_image == other.m_image && m_item == other.m_item; }

    private:
        friend class Range;
        Iterator(const SignalLayout& layout, std::size_t image, std::size_t end) : m_layout(&layout), m_image(image), m_end(end) {
            skipEmpty();
        }
        void skipEmpty() {
            while (m_image < m_end && m_item == m_layout->m_images[m_image].group->items().size()) ++m_image, m_item = 0;
        }
        const SignalLayout* m_layout = nullptr;
        std::size_t m_image = 0, m_item = 0, m_end = 0;
    };

    [[nodiscard]] Iterator begin() const { return {*m_layout, m_first, m_end}; }
    [[nodiscard]] Iterator end() const { return {*m_layout, m_end, m_end}; }
    [[nodiscard]] std::size_t size() const;

private:
    friend class SignalLayout;
    Range(const SignalLayout& layout, std::size_t first, std::size_t end) : m_layout(&layout), m_first(first), m_end(end) {}
    const SignalLayout* m_layout; ///< outlives this
    std::size_t m_first, m_end;   ///< images
};

} // namespace trundle
