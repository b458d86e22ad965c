#include "world/built_world.h"

namespace trundle {

Status BuiltWorld::tick() {
    if (m_fault) return stopped();
    ++m_block->header().sequence; // odd: write in progress
    const Status done = advance();
    ++m_block->header().sequence;
    return done;
}

Status BuiltWorld::advance() {
    if (const WorldDevice* failed = m_devices.act(m_ticks)) return stopAt(*failed);
    const double end = static_cast<double>(m_ticks + 1) * m_experiment->settings.tick;
    m_radio.advance(end);
    m_contactsReady = false;
    placeRobots();
    if (const auto fault = stepEngine()) return stopAt(*fault);
    if (const Status ended = endRobots(); !ended) return ended;
    ++m_ticks;
    m_radio.place();
    publish(); // before sense, so that devices can read the state signals of this tick
    m_supply.clearLoads();
    m_chargers.beginTick();
    if (const WorldDevice* failed = m_devices.sense(m_ticks)) return stopAt(*failed);
    return {};
}

void BuiltWorld::placeRobots() {
    for (const auto& [index, motion] : m_placed) {
        const BuiltRobot& robot = m_objects.robots()[index];
        m_engine->moveActor(robot.handles.actor, motion);
        m_objects.moveWorldJoints(robot, motion);
        m_regions.placed(index);
    }
    m_placed.clear();
}

std::optional<EngineFault> BuiltWorld::stepEngine() {
    const MonitoredCall call(*m_calls, m_solver, "step");
    return m_engine->step(m_experiment->settings.tick);
}

/// Those with a fault of their own in this tick.
Status BuiltWorld::endRobots() {
    const double tick = m_experiment->settings.tick, end = static_cast<double>(m_ticks + 1) * tick;
    const auto ended = m_robotFaults.update(m_objects, *m_engine, tick, end);
    for (const RobotEnd& robot : ended) m_devices.end(static_cast<std::uint32_t>(robot.robot));
    return ended.empty() || !m_robotFaults.isOver(m_objects) ? Status{} : stop(Code::BlowUp, ended.back().fault);
}

void BuiltWorld::publish() {
    m_regions.update(m_objects, *m_engine, m_ticks);
    m_signals.publish(m_objects, *m_engine, m_regions, m_ticks, *m_block);
    m_block->header().tick = m_ticks;
    m_block->header().time = static_cast<double>(m_ticks) * m_experiment->settings.tick;
}

} // namespace trundle
