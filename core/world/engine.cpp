#include "world/engine.h"

namespace trundle {

Result<JointHandle> Engine::addJoint(const JointSpec& joint, BodyHandle, BodyHandle) {
    return Error{Code::NotInEngine, joint.name + " joins robots, which this engine cannot"};
}

Result<CouplingHandle> Engine::addSpring(const SpringSpec& spring, BodyHandle, BodyHandle) {
    return Error{Code::NotInEngine, spring.name + " joins robots, which this engine cannot"};
}

void Engine::separate(ActorHandle, ActorHandle) {}

void Engine::setLatch(std::uint32_t, BodyHandle, std::optional<BodyHandle>) {}

bool Engine::latchHolds(std::uint32_t) const { return false; }

JointWrench Engine::latchWrench(std::uint32_t) const { return {}; }

} // namespace trundle
