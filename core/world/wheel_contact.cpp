#include "world/wheel_contact.h"

#include <cmath>

namespace trundle {

WheelContactResult wheelOnPlane(const WheelPose& wheel, const Vec3& normal, double distance, GroundContact& out) {
    Vec3 down = normal - normal.dot(wheel.axle) * wheel.axle; // from the tread to the centre, in the wheel's middle plane
    const double length = down.norm();
    if (length < 0.7) return WheelContactResult::Unknown;
    down /= length;
    out.position = wheel.centre - wheel.radius * down;
    out.normal = normal;
    out.depth = distance - normal.dot(out.position);
    return out.depth >= 0 ? WheelContactResult::Contact : WheelContactResult::NoContact;
}

WheelContactResult wheelOnBox(const WheelPose& wheel, const Vec3& boxCentre, const Mat3& boxAxes, const Vec3& half,
                              GroundContact& out) {
    const Vec3 local = boxAxes.transpose() * (wheel.centre - boxCentre);
    int face = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(local[k]) - half[k] > std::abs(local[face]) - half[face]) face = k;
    if (std::abs(local[face]) <= half[face]) return WheelContactResult::Unknown;
    for (int k = 0; k < 3; ++k)
        if (k != face && std::abs(local[k]) > half[k] - wheel.radius)
            return WheelContactResult::Unknown; // an edge may be in reach
    const double side = local[face] > 0 ? 1 : -1;
    const Vec3 normal = side * boxAxes.col(face);
    return wheelOnPlane(wheel, normal, normal.dot(boxCentre) + half[face], out);
}

} // namespace trundle
