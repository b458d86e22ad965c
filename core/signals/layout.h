#pragma once
// The layout of all signals of a world in one flat block, versioned and self-describing.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

enum class SignalType : std::uint32_t { Real = 1, Integer = 2, Boolean = 3 };
/// Truth: ground truth, available only in simulation; controllers read it only through groundTruth ports.
enum class SignalDirection : std::uint32_t { Output = 1, Command = 2, Truth = 3 };

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
};

class SignalLayout {
public:
    /// Begins a robot's image; all following add() calls belong to it.
    void beginRobot(std::string name);
    /// Returns the first slot.
    std::uint32_t add(std::string path, std::string unit, SignalType type, SignalDirection direction, std::uint32_t count = 1);

    [[nodiscard]] const SignalEntry* find(std::string_view path) const;
    [[nodiscard]] const std::vector<SignalEntry>& entries() const { return m_entries; }
    [[nodiscard]] const std::vector<ImageSpan>& images() const { return m_images; }
    [[nodiscard]] std::uint32_t slotCount() const { return m_slots; }
    /// Over all entries: two blocks with the same hash have the same layout. Differs between machines of different byte order.
    [[nodiscard]] std::uint64_t hash() const;

private:
    [[nodiscard]] std::size_t placeOf(std::string_view path) const;
    void enlargeIndex();

    std::vector<SignalEntry> m_entries;
    std::vector<ImageSpan> m_images;
    std::vector<std::uint32_t> m_index; ///< of m_entries, by the hash of the path, with gaps; for lookup only
    std::uint32_t m_slots = 0;
};

} // namespace trundle
