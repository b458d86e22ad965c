#pragma once
// Where something moved along straight axes comes to lie: flush with what is there, centred on it, at its mirror image, or in steps.

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "scene/queries/object_index.h"

namespace trundle {

/// What is moved and what it may snap to: bounds along the axes of the motion, from the world's origin.
struct SnapExtents {
    struct Target {
        Bounds bounds;
        std::optional<Bounds> source; ///< of a mirror image: what it is the image of
    };
    Mat3 axes = Mat3::Identity(); ///< columns, in W
    Bounds thing;                 ///< before it is moved; empty: there is nothing to snap
    std::vector<Target> targets;

    /// `moved`: bodies and geoms of one robot or static. Targets are the other visible geoms of that for which `counts` is true, its
    /// origin, and the mirror images, left for right, of those bodies and geoms that are as large as what is moved.
    [[nodiscard]] static SnapExtents of(const ObjectIndex& objects, const BodyPoses& poses, const std::vector<ObjectRef>& moved,
                                        const std::function<bool(const ObjectRef& geom)>& counts, const Mat3& axes);
};

/// All in m along the axes of the extents.
struct ExtentSnapOptions {
    Vec3 by = Vec3::Zero();      ///< how far the mouse moves it
    Vec3 stepped = Vec3::Zero(); ///< the same in steps
    Vec3 near = Vec3::Zero();    ///< what is farther away is not snapped to
    Vec3 favour = Vec3::Zero();  ///< a step must be nearer than a target by as much to be preferred
};

struct ExtentSnap {
    Vec3 by = Vec3::Zero();                  ///< m along the axes
    std::vector<std::array<Vec3, 2>> guides; ///< in W: around the thing and what it was snapped to, in the plane that they share
};

/// Along each axis the nearest of: the places where the low end, the middle or the high end of the thing is at one of a target (two ends
/// or two middles first), its middle at that of a mirror image, and the step.
[[nodiscard]] ExtentSnap snapExtents(const SnapExtents& extents, const ExtentSnapOptions& options);

} // namespace trundle
