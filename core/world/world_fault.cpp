#include "world/world_fault.h"

#include <algorithm>
#include <cstdio>

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

} // namespace trundle
