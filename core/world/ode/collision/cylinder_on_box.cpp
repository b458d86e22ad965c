#include "world/ode/collision/cylinder_on_box.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr int kMostRounds = 2000;
constexpr double kTouching = 1e-5; // m

} // namespace

/// From the box to the nearest point of the cylinder and back, until both are one point or a plane lies between the two.
bool overlap(const PlacedCylinder& cylinder, const PlacedBox& box) {
    const Vec3 centre = box.axes.transpose() * (cylinder.centre - box.centre); // all in the box's axes
    const Vec3 axis = box.axes.transpose() * cylinder.axes.col(2);
    Vec3 inBox = centre.cwiseMax(-box.half).cwiseMin(box.half);
    for (int round = 0; round < kMostRounds; ++round) {
        const Vec3 lever = inBox - centre;
        const double along = std::clamp(lever.dot(axis), -cylinder.half, cylinder.half);
        Vec3 across = lever - lever.dot(axis) * axis;
        if (const double out = across.norm(); out > cylinder.radius) across *= cylinder.radius / out;
        const Vec3 inCylinder = centre + along * axis + across;
        inBox = inCylinder.cwiseMax(-box.half).cwiseMin(box.half);
        const Vec3 way = inCylinder - inBox;
        if (way.squaredNorm() < kTouching * kTouching) return true;
        const double tilt = axis.dot(way), nearest = way.dot(centre) - std::abs(tilt) * cylinder.half -
                                                     cylinder.radius * std::sqrt(std::max(0.0, way.squaredNorm() - tilt * tilt));
        if (nearest > way.cwiseAbs().dot(box.half)) return false;
    }
    return false;
}

const FlatTouch& cylinderOnBox(const PlacedCylinder& cylinder, const PlacedBox& box, FlatPair& pair) {
    if (!overlap(cylinder, box)) {
        pair.touch.apart = true;
        pair.touch.contacts.clear();
        return pair.touch;
    }
    pair.first.setCylinder(cylinder.centre, cylinder.axes, cylinder.radius, cylinder.half);
    pair.second.setBox(box.centre, box.axes, box.half);
    return pair.findContacts();
}

} // namespace trundle
