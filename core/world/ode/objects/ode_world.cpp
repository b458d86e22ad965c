#include "world/ode/objects/ode_world.h"

#include "world/ode/objects/ode_records.h"

namespace trundle {

OdeWorld::OdeWorld(const EngineSettings& settings) : m_id(dWorldCreate()) {
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
    if (!m_threading) return;
    if (m_abandoned) abandon(m_threading); // its list of jobs was left half done, and its destructor would abort over that
    else OdeDeleter<dThreadingFreeImplementation>()(m_threading);
}

void OdeWorld::makeThreading() {
    m_threading = dThreadingAllocateSelfThreadedImplementation();
    if (m_threading) dWorldSetStepThreadingImplementation(m_id, dThreadingImplementationGetFunctions(m_threading), m_threading);
}

void OdeWorld::replaceThreading() {
    abandon(m_threading);
    makeThreading();
}

} // namespace trundle
