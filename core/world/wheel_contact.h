#pragma once
// The one contact of a wheel with flat ground, computed: radius exact, at the middle of the tread. So too for a ball on an axle:
// were its contact to wander with every lean of the robot, the track would change with the load.

#include <optional>

#include <trundle/geometry.h>

namespace trundle {

/// A wheel as it is in the world.
struct WheelPose {
    Vec3 centre;
    Vec3 axle; ///< unit
    double radius = 0;
};

struct GroundContact {
    Vec3 position;
    Vec3 normal;      ///< out of the ground
    double depth = 0; ///< >= 0
};

enum class WheelContactResult { Contact, NoContact, Unknown };

/// Against the half space below `normal . x = distance`. Unknown: the wheel leans so far that its rim or side touches.
[[nodiscard]] WheelContactResult wheelOnPlane(const WheelPose& wheel, const Vec3& normal, double distance, GroundContact& out);

/// Against a box. Unknown near its edges and from inside it.
[[nodiscard]] WheelContactResult wheelOnBox(const WheelPose& wheel, const Vec3& boxCentre, const Mat3& boxAxes, const Vec3& half,
                                            GroundContact& out);

} // namespace trundle
