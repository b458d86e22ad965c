#include "world/ode/state_check.h"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace trundle {

namespace {

constexpr double kFarthest = 1e5;    // m
constexpr double kFastest = 200;     // m/s
constexpr double kFastestTurn = 1e4; // rad/s

bool within(const dReal* v, double most) { // false for NaN
    return std::abs(v[0]) <= most && std::abs(v[1]) <= most && std::abs(v[2]) <= most &&
           v[0] * v[0] + v[1] * v[1] + v[2] * v[2] <= most * most;
}

bool isFinite(const dReal* v, int count) {
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

std::string text(const char* format, double value) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

} // namespace

std::optional<EngineFault> findFault(const OdeObjects& objects, const JointRows& rows, const ClusterSolver& solver) {
    for (std::uint32_t i = 0; i < objects.bodies.size(); ++i) {
        const OdeBody& b = objects.bodies[i];
        if (within(b.p, kFarthest) && within(b.v, kFastest) && within(b.w, kFastestTurn) && isFinite(b.q, 4)) continue;
        const BodyHandle id{i};
        if (!isFinite(b.p, 3) || !isFinite(b.q, 4) || !isFinite(b.v, 3) || !isFinite(b.w, 3))
            return EngineFault{id, "its state is no longer a number"};
        if (!within(b.v, kFastest))
            return EngineFault{id, text("it moves at %.3g m/s", vec(b.v).norm()) + text(", more than %g m/s", kFastest)};
        if (!within(b.w, kFastestTurn))
            return EngineFault{id, text("it turns at %.3g rad/s", vec(b.w).norm()) + text(", more than %g rad/s", kFastestTurn)};
        return EngineFault{id, text("it is farther than %g m from the origin", kFarthest)};
    }
    for (const OdeJoint& joint : objects.joints) {
        if (joint.type == JointType::Slider || joint.type == JointType::Fixed) continue;
        Vec3 gap = rows.anchorGap(joint);
        if (joint.type == JointType::Suspension) {
            const Vec3 axis = turn(objects.bodies[joint.parent].r, joint.slideAxis);
            gap -= gap.dot(axis) * axis;
        }
        const double open = gap.norm(), slack = solver.isQuick(joint.child) ? 5 : 1; // it closes joint gaps over several steps
        if (open > slack * joint.gapLimit)
            return EngineFault{{joint.child}, text("its joint is torn open by %.3g mm", 1e3 * open)};
    }
    return {};
}

EngineFault interruptedFault(const OdeObjects& objects) {
    std::uint32_t lightest = 0;
    dReal least = HUGE_VAL;
    for (std::uint32_t i = 0; i < objects.bodies.size(); ++i) {
        const OdeBody& b = objects.bodies[i];
        if (!isFinite(b.p, 3) || !isFinite(b.q, 4) || !isFinite(b.v, 3) || !isFinite(b.w, 3))
            return {{i}, "its state is no longer a number"};
        dMass mass;
        dBodyGetMass(b.id, &mass);
        if (mass.mass >= least) continue;
        least = mass.mass;
        lightest = i;
    }
    return {{lightest}, "the solver finds no valid forces for it"};
}

} // namespace trundle
