// Faults: which body stopped the world, and advice for the user.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "world/built_world.h"

namespace trundle {

namespace {

constexpr double kDeep = 0.005;     // m; deeper than any normal contact
constexpr double kUneven = 1e4;     // ratio of the mass of a robot's heaviest body to that of this one
constexpr double kVeryLight = 1e-6; // kg

std::string threeDigits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

} // namespace

std::pair<const BuiltRobot*, std::size_t> BuiltWorld::ownerOf(BodyHandle body) const {
    for (const BuiltRobot& robot : m_robots) {
        const auto& bodies = robot.handles.bodies;
        const auto found = std::find(bodies.begin(), bodies.end(), body);
        if (found != bodies.end()) return {&robot, static_cast<std::size_t>(found - bodies.begin())};
    }
    return {nullptr, 0};
}

/// Advice for the most likely cause: deep penetration, much lighter than its neighbours, or forces too strong for the tick.
std::string BuiltWorld::faultAdvice(BodyHandle body) const {
    const auto [robot, index] = ownerOf(body);
    if (!robot) return "a smaller Tick may help";
    double deepest = kDeep;
    std::string partner;
    for (std::size_t i = 0; i < m_engine->contactCount(); ++i) {
        const EngineContact c = m_engine->contact(i);
        const bool own = c.actor == robot->handles.actor.index;
        if (!(own || c.partner == robot->handles.actor.index) || !(c.depth > deepest)) continue;
        deepest = c.depth;
        partner = m_geomPaths[own ? c.second : c.first];
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
    return "a smaller Tick (now " + threeDigits(m_experiment->settings.tick) +
           " s), weaker motors and springs or more mass may help";
}

Status BuiltWorld::stopAt(const EngineFault& fault) {
    const double time = static_cast<double>(m_ticks + 1) * m_experiment->settings.tick;
    const bool known = fault.body.valid() && fault.body.index < m_bodyPaths.size();
    return stop(known ? Code::BlowUp : Code::EngineFault,
                {known ? m_bodyPaths[fault.body.index] : "", time, fault.reason + "; " + faultAdvice(fault.body),
                 known ? m_bodyRanges[fault.body.index] : SourceRange{}});
}

Status BuiltWorld::stop(Code code, Fault fault) {
    m_fault = std::move(fault);
    m_faultCode = code;
    return stopped();
}

Status BuiltWorld::stopped() const {
    char time[32];
    std::snprintf(time, sizeof time, "%.6g", m_fault->time);
    const std::string who = m_fault->body.empty() ? "the simulation" : m_fault->body;
    return Error{m_faultCode, who + " stopped at t = " + time + " s: " + m_fault->reason};
}

} // namespace trundle
