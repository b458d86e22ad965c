#pragma once
#include <vector>

#include "model/experiment_spec.h"

namespace trundle {

/// Paint on scenery: flat boxes and cylinders, 2 mm thick or less, that are visible and do not collide. Rays pass through them; a sensor
/// that looks at what is below sees their material.
class FloorMarks {
public:
    /// Adds a geom of scenery if it is a mark. `geom` must outlive this object.
    void add(const GeomSpec& geom, const Pose& X_WG);

    struct Mark {
        const GeomSpec* geom = nullptr;
        Pose X_WG;
        Vec3 low = Vec3::Zero(), high = Vec3::Zero(); ///< of its bounds in W
    };
    /// The uppermost mark at a point (W) of the surface that carries it; of those as high the last one. nullptr: none.
    [[nodiscard]] const Mark* at(const Vec3& point) const;

private:
    std::vector<Mark> m_marks;
};

} // namespace trundle
