#include "world/world_fault.h"

#include <algorithm>
#include <cstdio>

#include "model/passive_objects.h"

namespace trundle {

namespace {

constexpr double kDeep = 0.005;     // m; deeper than any normal contact
constexpr double kUneven = 1e4;     // ratio of the mass of a robot's heaviest body to that of this one
constexpr double kVeryLight = 1e-6; // kg
constexpr std::size_t kMostClosedJoints = 20;

std::string threeDigits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

} // namespace

std::string faultAdvice(BodyHandle body, const WorldObjects& objects, const Engine& engine, double tick) {
    const auto [robot, index] = objects.ownerOf(body);
    if (!robot) return "a smaller Tick may help";
    double deepest = kDeep;
    std::string partner;
    for (std::size_t i = 0; i < engine.contactCount(); ++i) {
        const EngineContact c = engine.contact(i);
        const bool own = c.actor == robot->handles.actor.index;
        if (!(own || c.partner == robot->handles.actor.index) || !(c.depth > deepest)) continue;
        deepest = c.depth;
        partner = objects.geomPath(own ? c.second : c.first);
    }
    if (!partner.empty())
        return "its robot was " + threeDigits(1e3 * deepest) + " mm deep in " + partner +
               ": start it clear of that, or give it less speed or a smaller Tick";
    double heaviest = 0;
    for (const BodySpec& b : robot->spec->config->bodies) heaviest = std::max(heaviest, b.mass.mass);
    const double mass = robot->spec->config->bodies[index].mass.mass;
    if (mass < kVeryLight || heaviest > kUneven * mass)
        return "it weighs only " + threeDigits(mass) + " kg" +
               (heaviest > kUneven * mass ? " beside " + threeDigits(heaviest) + " kg of a body of the same robot" : "") +
               ": give it more mass, or set Solver=quick";
    return "a smaller Tick (now " + threeDigits(tick) + " s), weaker motors and springs or more mass may help";
}

Fault faultFrom(const EngineFault& fault, const WorldObjects& objects, const Engine& engine, double tick, double time) {
    const bool known = fault.body.valid() && objects.isBody(fault.body.index);
    return {known ? objects.bodyPaths()[fault.body.index] : "", time,
            fault.reason + "; " + faultAdvice(fault.body, objects, engine, tick),
            known ? objects.bodyRange(fault.body.index) : SourceRange{}};
}

std::span<const RobotEnd> RobotFaults::update(const WorldObjects& objects, const Engine& engine, double tick, double time) {
    const auto [ended, closed] = engine.faults();
    while (m_report.closedJoints.size() < std::min(closed.size(), kMostClosedJoints)) {
        const EngineFault& fault = closed[m_report.closedJoints.size()];
        m_report.closedJoints.push_back(
            {objects.bodyPaths()[fault.body.index], time, fault.reason, objects.bodyRange(fault.body.index)});
    }
    const std::size_t before = m_report.ends.size();
    while (m_report.ends.size() < ended.size()) {
        const EngineFault& fault = ended[m_report.ends.size()];
        const auto robot = static_cast<std::size_t>(objects.ownerOf(fault.body).first - objects.robots().data());
        m_report.ends.push_back({robot, faultFrom(fault, objects, engine, tick, time)});
    }
    return std::span(m_report.ends).subspan(before);
}

bool RobotFaults::isOver(const WorldObjects& objects) const {
    const std::vector<BuiltRobot>& robots = objects.robots();
    const auto isRobot = [](const BuiltRobot& robot) { return !isPassive(*robot.spec); };
    const auto ended = static_cast<std::size_t>(
        std::ranges::count_if(m_report.ends, [&](const RobotEnd& end) { return isRobot(robots[end.robot]); }));
    const auto all = static_cast<std::size_t>(std::ranges::count_if(robots, isRobot));
    return all > 0 ? ended == all : m_report.ends.size() == robots.size();
}

const RobotFaultReport& World::robotFaults() const {
    static const RobotFaultReport none;
    return none;
}

bool hasEnded(const World& world, std::size_t robot) {
    const auto& ends = world.robotFaults().ends;
    return std::ranges::find(ends, robot, &RobotEnd::robot) != ends.end();
}

} // namespace trundle
