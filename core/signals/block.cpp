#include "signals/block.h"

#include <cstring>
#include <new>
#include <type_traits>

#include "base/assert.h"

namespace trundle {

static_assert(std::is_trivially_copyable_v<BlockHeader> && sizeof(BlockHeader) % sizeof(double) == 0,
              "the slots follow the header directly, aligned as doubles");

std::size_t SignalBlock::bytesNeeded(const SignalLayout& layout) {
    return sizeof(BlockHeader) + layout.slotCount() * sizeof(double);
}

SignalBlock::SignalBlock(const SignalLayout& layout) : SignalBlock(layout, nullptr) {}

SignalBlock::SignalBlock(const SignalLayout& layout, void* memory) {
    if (!memory) {
        m_owned = std::make_unique<std::uint64_t[]>(bytesNeeded(layout) / sizeof(std::uint64_t));
        memory = m_owned.get();
    }
    std::memset(memory, 0, bytesNeeded(layout));
    m_header = new (memory) BlockHeader;
    m_header->layoutHash = layout.hash();
    m_header->slotCount = layout.slotCount();
    m_slots = {reinterpret_cast<double*>(static_cast<char*>(memory) + sizeof(BlockHeader)), layout.slotCount()};
}

void SignalBlock::copyFrom(const SignalBlock& other) {
    TRUNDLE_ASSERT(m_header->layoutHash == other.m_header->layoutHash && m_slots.size() == other.m_slots.size());
    *m_header = *other.m_header;
    if (!m_slots.empty()) std::memcpy(m_slots.data(), other.m_slots.data(), m_slots.size_bytes());
}

} // namespace trundle
