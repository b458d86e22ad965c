#pragma once

#include <ode/ode.h>

namespace trundle {

/// The working memory of one world's steps. A fault thrown out of a step leaves blocks behind that ODE knows no longer; this one does.
class StepMemory {
public:
    explicit StepMemory(dWorldID world);
    ~StepMemory() { freeAll(); } ///< after the world
    StepMemory(const StepMemory&) = delete;
    StepMemory& operator=(const StepMemory&) = delete;

    /// What this thread's next step asks for belongs to this world.
    void use();
    /// Only after dWorldCleanupWorkingMemory(), or the end of the world: ODE uses none of it then.
    void freeAll();

private:
    struct alignas(16) Block { ///< in front of ODE's bytes; 16: what ODE expects of malloc()
        Block *before, *after;
    };
    static void* allocate(dsizeint size);
    static void* shrink(void* bytes, dsizeint, dsizeint) { return bytes; }
    static void release(void* bytes, dsizeint);

    static thread_local StepMemory* t_used;
    Block m_all{&m_all, &m_all}; ///< a ring
};

} // namespace trundle
