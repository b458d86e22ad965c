#pragma once
// ODE's world, with threads of its own: ODE's default implementation of them is shared by all worlds.

#include <memory>

#include <ode/ode.h>

#include "world/engine.h"
#include "world/ode/objects/island_threads.h"
#include "world/ode/objects/ode_fault.h"
#include "world/ode/objects/step_memory.h"

namespace trundle {

class OdeWorld {
public:
    explicit OdeWorld(const EngineSettings& settings);
    ~OdeWorld();
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    [[nodiscard]] dWorldID id() const { return m_id; }
    void step(double h); ///< exact; may throw OdeFault, after which recover() is to be called
    void quickStep(double h);
    /// After a fault thrown out of the middle of a step: its list of jobs is half done, so it gets a new implementation of threads, and new
    /// working memory.
    void recover();
    /// The same where the world is not stepped again.
    void abandonThreading() { m_abandoned = true; }
    /// Whether the next steps are shared by all threads, which is worth it for many islands.
    void share(bool shared);
    /// For steps whose result would depend on threads; then back to what there is.
    void useOneThread(bool one);
    /// nullptr: there is one thread.
    [[nodiscard]] WorkTeam* team() { return m_team.get(); }

private:
    void makeThreading();

    dWorldID m_id = nullptr;
    StepMemory m_memory;
    std::unique_ptr<WorkTeam> m_team;            ///< with more than one thread
    std::unique_ptr<IslandThreads> m_islands;    ///< of the team
    dThreadingImplementationID m_threading = nullptr; ///< without a team: ODE's for the calling thread
    bool m_abandoned = false;
};

/// Destroys what ODE created. After a fault it may not come apart: better lost than dead.
template <auto destroy> struct OdeDeleter {
    template <class T> void operator()(T* created) const noexcept {
        try {
            destroy(created);
        } catch (const OdeFault&) {}
    }
};
using OwnedJointGroup = std::unique_ptr<dxJointGroup, OdeDeleter<dJointGroupDestroy>>;
using OwnedGeom = std::unique_ptr<dxGeom, OdeDeleter<dGeomDestroy>>;

} // namespace trundle
