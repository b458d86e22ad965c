// Checks of joints at the top level: their point is in the world, and stays there when a robot is moved; and of the loops that they close.

#include <algorithm>
#include <cmath>
#include <set>

#include "check/body_groups.h"
#include "check/checks.h"
#include "check/extent.h"

namespace trundle {

namespace {

constexpr double kFar = 0.5;       // of the size of the body: a drawbar may be as long without being drawn
constexpr double kLeastFar = 0.05; // m

/// From a point to the box around a body's shapes, in metres; 0 for a body without any. `size`: the box's diagonal.
double distanceTo(const BodySpec& body, const Vec3& point, double& size) {
    if (body.geoms.empty()) return 0;
    const auto [low, high] = boxAround(body);
    size = (high - low).norm();
    return (low - point).cwiseMax(point - high).cwiseMax(0.0).norm();
}

/// Reports the first joint at the top level between bodies that others connect already. Two joints for the same bodies are no loop.
void checkLoops(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    std::vector<int> first; // body of each robot
    int count = 0;
    for (const RobotSpec& robot : experiment.robots) {
        first.push_back(count);
        count += static_cast<int>(robot.config->bodies.size());
    }
    BodyGroups groups(static_cast<std::size_t>(count));
    for (std::size_t r = 0; r < experiment.robots.size(); ++r) {
        const auto at = [&](int body) { return body == kWorldBody ? kWorldBody : first[r] + body; };
        for (const JointSpec& joint : experiment.robots[r].config->joints) groups.join(at(joint.parent), at(joint.child));
    }
    std::set<std::pair<int, int>> joined;
    for (const Link<JointSpec>& link : experiment.joints) {
        const auto at = [&](int robot, int body) {
            return robot == kWorldBody ? kWorldBody : first[static_cast<std::size_t>(robot)] + body;
        };
        const int parent = at(link.parentRobot, link.spec.parent), child = at(link.childRobot, link.spec.child);
        if (!joined.insert(std::minmax(parent, child)).second || groups.join(parent, child)) continue;
        diagnostics.hint(Code::ClosedLoop, link.spec.nameRange,
                         link.spec.name +
                             " closes a loop of joints: other joints connect what it joins already; the loop is held by forces "
                             "alone and drifts a little, and a Spring needs no loop");
        return;
    }
}

} // namespace

void checkLinks(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    checkLoops(experiment, diagnostics);
    std::set<SourceRange> reported; // of a Repeat one member
    for (const Link<JointSpec>& link : experiment.joints) {
        const bool isReported = reported.contains(link.spec.nameRange);
        if (link.spec.type == JointType::Fixed || link.spec.type == JointType::Slider) continue; // they have no point
        for (const auto& [robotIndex, bodyIndex] :
             {std::pair(link.parentRobot, link.spec.parent), {link.childRobot, link.spec.child}}) {
            if (robotIndex == kWorldBody) continue;
            const RobotSpec& robot = experiment.robots[static_cast<std::size_t>(robotIndex)];
            const BodySpec& body = robot.config->bodies[static_cast<std::size_t>(bodyIndex)];
            double size = 0;
            const double far = distanceTo(body, (robot.pose * body.pose).inverse() * link.spec.anchor, size);
            if (isReported || far <= std::max(kLeastFar, kFar * size)) continue;
            reported.insert(link.spec.nameRange);
            diagnostics.warning(Code::BadJoint, link.spec.nameRange,
                                "the Anchor of " + link.spec.name + " is " + lengthText(far) + " away from " + robot.name + "." +
                                    body.name + "; it is a point in the world at the start, where both bodies should meet");
        }
    }
}

} // namespace trundle
