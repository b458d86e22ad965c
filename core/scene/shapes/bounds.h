#pragma once
#include <algorithm>
#include <limits>

#include <trundle/geometry.h>

namespace trundle {

/// Axis-aligned bounding box in world coordinates; empty until a point is added.
struct Bounds {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

    [[nodiscard]] bool empty() const { return !(low.x() <= high.x()); }
    [[nodiscard]] Vec3 centre() const { return 0.5 * (low + high); }
    [[nodiscard]] Vec3 size() const { return high - low; }
    [[nodiscard]] double radius() const { return empty() ? 0.0 : 0.5 * size().norm(); }
    [[nodiscard]] Vec3 corner(int i) const {
        return {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()};
    }
    /// 0 for points inside the box.
    [[nodiscard]] double distanceTo(const Vec3& point) const {
        return empty() ? 0.0 : (point - point.cwiseMax(low).cwiseMin(high)).norm();
    }

    void add(const Vec3& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    void add(const Bounds& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    void grow(double by) {
        low.array() -= by;
        high.array() += by;
    }
};

} // namespace trundle
