#include <algorithm>
#include <set>

#include "check/checks.h"
#include "check/linked_bodies.h"

namespace trundle {

namespace {

constexpr double kMaxUneven = 1e4;

void checkJoint(const JointSpec& joint, const RobotConfigSpec& config, Diagnostics& diagnostics) {
    if (joint.parent == kWorldBody) return;
    const BodySpec* light = &config.bodies[static_cast<std::size_t>(joint.child)];
    const BodySpec* heavy = &config.bodies[static_cast<std::size_t>(joint.parent)];
    if (light->mass.mass > heavy->mass.mass) std::swap(light, heavy);
    const double ratio = heavy->mass.mass / light->mass.mass;
    if (!(ratio > kMaxUneven)) return;
    diagnostics.warning(Code::MassRatio, light->nameRange,
                        light->name + (config.name.empty() ? "" : " of " + config.name) + " weighs " +
                            figureText(light->mass.mass) + " kg and " + heavy->name + ", which " + joint.name + " joins to it, " +
                            figureText(heavy->mass.mass) + " kg: 1 to " + figureText(ratio) +
                            " is more than the solver holds together (1 to 10000); give " + light->name + " more mass or " +
                            heavy->name + " less");
}

} // namespace

void checkMasses(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config || !seen.insert(robot.config.get()).second) continue;
        for (const JointSpec& joint : robot.config->joints) checkJoint(joint, *robot.config, diagnostics);
    }
    const RobotConfigSpec linked = linkedBodies(experiment);
    for (const JointSpec& joint : linked.joints) checkJoint(joint, linked, diagnostics);
}

} // namespace trundle
