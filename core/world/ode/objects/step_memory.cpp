#include "world/ode/objects/step_memory.h"

#include <cstdlib>

namespace trundle {

thread_local StepMemory* StepMemory::t_used = nullptr;

StepMemory::StepMemory(dWorldID world) {
    const dWorldStepMemoryFunctionsInfo functions{sizeof(functions), allocate, shrink, release};
    dWorldSetStepMemoryManager(world, &functions);
}

void StepMemory::use() { t_used = this; }

void* StepMemory::allocate(dsizeint size) {
    auto* const block = static_cast<Block*>(std::malloc(sizeof(Block) + size));
    if (!block) return nullptr; // ODE's step fails then
    Block& all = t_used->m_all;
    *block = {&all, all.after};
    all.after->before = block;
    all.after = block;
    return block + 1;
}

void StepMemory::release(void* bytes, dsizeint) {
    Block* const block = static_cast<Block*>(bytes) - 1;
    block->before->after = block->after;
    block->after->before = block->before;
    std::free(block);
}

void StepMemory::freeAll() {
    while (m_all.after != &m_all) release(m_all.after + 1, 0);
}

} // namespace trundle
