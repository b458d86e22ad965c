#include <cmath>

#include "base/platform/module_text.h"
#include "world/built_world.h"

namespace trundle {

namespace {

double* put(double* to, const Vec3& v) {
    to[0] = v.x();
    to[1] = v.y();
    to[2] = v.z();
    return to + 3;
}

double* put(double* to, const Vec3& position, const Quat& q) {
    to = put(to, position);
    to[0] = q.w();
    to[1] = q.x();
    to[2] = q.y();
    to[3] = q.z();
    return to + 4;
}

} // namespace

Status BuiltWorld::tick() {
    if (m_fault) return stopped();
    ++m_block->header().sequence; // odd: write in progress
    bool good = callDevices(true);
    if (good) {
        airTime();
        m_contactsReady = false;
        if (const auto fault = stepEngine()) return stopAt(*fault);
        ++m_ticks;
        placeRadios();
        publish(); // before sense, so that devices can read the state signals of this tick
        good = callDevices(false);
    }
    ++m_block->header().sequence;
    return good ? Status{} : stopped();
}

std::optional<EngineFault> BuiltWorld::stepEngine() {
    const MonitoredCall call(*m_calls, m_solver, "step");
    return m_engine->step(m_experiment->settings.tick);
}

/// Calls act or sense of every device. False if one failed, which stops the world.
bool BuiltWorld::callDevices(bool acting) {
    m_inAct = acting;
    m_services.time = static_cast<double>(m_ticks) * m_experiment->settings.tick;
    for (const DeviceCall& call : acting ? m_acting : m_sensing) {
        m_current = call.device;
        const MonitoredCall monitored(*m_calls, call.device->target, acting ? "act" : "sense");
        const std::int32_t answer = call.run(call.instance, &m_services);
        if (answer != 0 || (m_deviceNoted && !call.device->failure.empty())) return failed(*call.device);
    }
    m_current = nullptr;
    return true;
}

bool BuiltWorld::failed(Device& device) {
    if (device.failure.empty()) {
        const std::string why = device.kind->lastError ? moduleMessage(device.kind->lastError(device.instance)) : std::string();
        device.note(why.empty() ? "it reported no reason" : why);
    }
    m_current = nullptr;
    (void)stop(Code::DeviceSetup, {"", m_services.time, device.path + ": " + device.failure, device.spec->nameRange});
    return false;
}

void BuiltWorld::publish() {
    double* slots = m_block->slots().data();
    for (const BuiltRobot& robot : m_robots) publishRobot(robot, slots + robot.image);
    m_block->header().tick = m_ticks;
    m_block->header().time = static_cast<double>(m_ticks) * m_experiment->settings.tick;
}

/// Same order as layOutSignals().
void BuiltWorld::publishRobot(const BuiltRobot& robot, double* to) const {
    const BodyState& first = m_engine->state(robot.handles.bodies[0]);
    const Pose frame = centredPose(robot);
    to = put(to, frame.position, frame.rotation);
    to = put(to, first.linear + first.angular.cross(frame.position - first.position));
    to = put(to, first.angular);
    for (const BodyHandle body : robot.handles.bodies) {
        const BodyState& s = m_engine->state(body);
        to = put(to, s.position, s.rotation);
        to = put(to, s.linear);
        to = put(to, s.angular);
    }
    for (const JointHandle joint : robot.handles.joints) {
        if (!m_jointTurns[joint.index]) continue;
        *to++ = m_engine->jointPosition(joint);
        *to++ = m_engine->jointRate(joint);
    }
}

/// At tick 0 exactly the pose of the text, bit for bit.
Pose BuiltWorld::framePose(const BuiltRobot& robot) const {
    if (m_ticks == 0) return robot.spec->pose;
    const BodyState& first = m_engine->state(robot.handles.bodies[0]);
    const Pose body{first.position, first.rotation};
    return robot.frameIsFirst ? body : body * robot.frameInFirst;
}

Pose BuiltWorld::centredPose(const BuiltRobot& robot) const {
    Pose pose = framePose(robot);
    if (robot.centre) pose.position = pose * *robot.centre;
    return pose;
}

} // namespace trundle
