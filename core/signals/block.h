#pragma once
// One block of signal values: a header and the slots, contiguous and without pointers, so that it can be in shared memory, a
// record in a file or the payload of a packet.

#include <cstdint>
#include <memory>
#include <span>

#include "signals/layout.h"

namespace trundle {

struct BlockHeader {
    std::uint32_t magic = 0x4b4c4254; ///< "TBLK"
    std::uint32_t version = 1;
    std::uint64_t layoutHash = 0;
    std::uint64_t tick = 0;     ///< completed ticks
    std::uint64_t sequence = 0; ///< odd while the block is being written
    double time = 0;            ///< s
    std::uint64_t slotCount = 0;
};

/// Owns its memory unless it was constructed over the caller's memory.
class SignalBlock {
public:
    explicit SignalBlock(const SignalLayout& layout);
    /// Uses `bytesNeeded(layout)` bytes owned by the caller (shared memory), which must outlive the block.
    SignalBlock(const SignalLayout& layout, void* memory);

    [[nodiscard]] static std::size_t bytesNeeded(const SignalLayout& layout);
    [[nodiscard]] BlockHeader& header() { return *m_header; }
    [[nodiscard]] const BlockHeader& header() const { return *m_header; }
    [[nodiscard]] std::span<double> slots() { return m_slots; }
    [[nodiscard]] std::span<const double> slots() const { return m_slots; }
    void copyFrom(const SignalBlock& other); ///< the layouts must be equal

private:
    std::unique_ptr<std::uint64_t[]> m_owned;
    BlockHeader* m_header = nullptr;
    std::span<double> m_slots;
};

} // namespace trundle
