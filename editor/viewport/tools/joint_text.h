#pragma once
#include <string>

#include "model/body_spec.h"

namespace trundle {

/// What a joint is made from: two bodies and the place where the second one was picked.
struct JointPick {
    std::string parent, child;      ///< as in the text: "chassis", "left.wheel", "world"
    const BodySpec* body = nullptr; ///< the child
    Pose X_CB;                      ///< of the child at the start, in the frame of the text
    Vec3 point = Vec3::Zero();      ///< picked on the child, in that frame, m
    Vec3 normal = Vec3::UnitZ();    ///< of its surface there
};

/// "Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 }", without what is the default. A wheel turns about its own axis and centre;
/// other bodies about the picked point, or slide along the normal of the face, turned to a main axis that is near. `step`: m, of an Anchor.
[[nodiscard]] std::string jointText(const std::string& kind, const JointPick& pick, double step);

} // namespace trundle
