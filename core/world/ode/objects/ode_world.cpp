#include "world/ode/objects/ode_world.h"

#include "world/ode/objects/ode_records.h"

namespace trundle {

OdeWorld::OdeWorld(const EngineSettings& settings) : m_id(dWorldCreate()), m_memory(m_id) {
    if (settings.threads > 1) m_team = std::make_unique<WorkTeam>(settings.threads);
    if (m_team && m_team->size() == 1) m_team.reset();
    makeThreading();
    dWorldSetGravity(m_id, settings.gravity.x(), settings.gravity.y(), settings.gravity.z());
    dWorldSetCFM(m_id, kWorldCfm); // before any joint: joints copy these at birth
    dWorldSetERP(m_id, settings.errorReduction);
    dWorldSetContactMaxCorrectingVel(m_id, dInfinity); // ContactRows has a limit of its own
    dWorldSetContactSurfaceLayer(m_id, 0);
    dWorldSetQuickStepNumIterations(m_id, settings.iterations);
    dWorldSetAutoDisableFlag(m_id, 0);
}

OdeWorld::~OdeWorld() {
    OdeDeleter<dWorldDestroy>()(m_id);
    if (m_abandoned) abandon(m_threading); // its list of jobs was left half done, and its destructor would abort over that
    else if (m_threading) OdeDeleter<dThreadingFreeImplementation>()(m_threading);
}

void OdeWorld::makeThreading() {
    if (m_team) {
        auto islands = std::make_unique<IslandThreads>(*m_team);
        islands->giveTo(m_id); // the world returns what it has of the one before
        m_islands = std::move(islands);
        return;
    }
    m_threading = dThreadingAllocateSelfThreadedImplementation();
    if (m_threading) dWorldSetStepThreadingImplementation(m_id, dThreadingImplementationGetFunctions(m_threading), m_threading);
}

void OdeWorld::step(double h) {
    m_memory.use();
    dWorldStep(m_id, h);
}

void OdeWorld::quickStep(double h) {
    m_memory.use();
    dWorldQuickStep(m_id, h);
}

void OdeWorld::recover() {
    dWorldCleanupWorkingMemory(m_id);
    m_memory.freeAll();
    if (m_threading) abandon(m_threading);
    makeThreading();
}

void OdeWorld::share(bool shared) {
    if (m_islands) m_islands->share(shared);
}

void OdeWorld::useOneThread(bool one) {
    if (m_islands) dWorldSetStepIslandsProcessingMaxThreadCount(m_id, one ? 1 : dTHREADING_THREAD_COUNT_UNLIMITED);
}

} // namespace trundle
