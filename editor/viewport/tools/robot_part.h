#pragma once
#include <optional>
#include <string>

#include <trundle/geometry.h>

namespace trundle {

/// A part from the Library for a robot that looks along x, as text: a Body first, then the joint that holds it and its devices. The
/// side of the robot that it is written for is the horizontal direction of its Pos.
struct RobotPart {
    Vec3 position = Vec3::Zero(); ///< Pos of the body as written, m, in the config's frame
    Vec3 side = Vec3::UnitX();    ///< unit vector of the face that it is written for
    bool isWheel = false;         ///< its hinge turns about `side`, so it fits a face and the one opposite alike
    Vec3 axis = Vec3::UnitZ();    ///< of its joint, as written

    /// Nothing if the text does not begin with a body that has a joint.
    [[nodiscard]] static std::optional<RobotPart> of(const std::string& text);

    /// The rotation that brings it to a face with this outward normal (config frame).
    [[nodiscard]] Quat rotationTo(const Vec3& normal) const;
};

/// Where a part is put on a robot.
struct PartLocation {
    Pose X_CB;          ///< of its body in the frame of the config
    std::string parent; ///< the body that it is joined to
    std::string side;   ///< "left" and "right" are put before the names of a wheel, its joint and its devices; empty: no side
};

/// The text with Pos and HPR of the body, Parent and Axis of its joint, and the names for its location.
[[nodiscard]] std::string textAt(const std::string& text, const RobotPart& part, const PartLocation& location);

/// The text of a device with a Body, a Pos and an HPR: the last block of the text is put on that body.
[[nodiscard]] std::string deviceTextAt(const std::string& text, const std::string& body, const Pose& X_BD);

} // namespace trundle
