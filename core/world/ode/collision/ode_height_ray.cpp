#include "world/ode/collision/ode_height_ray.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

/// Möller-Trumbore intersection test, for both sides.
std::optional<HeightHit> rayOnTriangle(const HeightRay& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, p = ray.direction.cross(ac);
    const double det = ab.dot(p);
    if (std::abs(det) < 1e-14 * ab.norm() * ac.norm()) return {};
    const Vec3 s = ray.origin - a, q = s.cross(ab);
    const double u = s.dot(p) / det, v = ray.direction.dot(q) / det, t = ac.dot(q) / det;
    constexpr double kSlack = 1e-9; // closes gaps between neighbours
    if (u < -kSlack || v < -kSlack || u + v > 1 + kSlack || t < 0 || t > ray.range) return {};
    Vec3 normal = ab.cross(ac).normalized();
    if (normal.y() < 0) normal = -normal;
    return HeightHit{t, normal};
}

} // namespace

std::optional<HeightHit> rayOnHeights(const HeightRay& ray, const HeightMap& map, double width, double depth, double height) {
    const int columns = static_cast<int>(map.columns) - 1, rows = static_cast<int>(map.rows) - 1;
    const double dx = width / columns, dz = depth / rows;
    // The interval of the ray above the map.
    double from = 0, to = ray.range;
    const double start[2] = {ray.origin.x(), ray.origin.z()}, along[2] = {ray.direction.x(), ray.direction.z()},
                 half[2] = {width / 2, depth / 2};
    for (int k = 0; k < 2; ++k) {
        if (std::abs(along[k]) < 1e-12) {
            if (std::abs(start[k]) > half[k]) return {};
            continue;
        }
        const double a = (-half[k] - start[k]) / along[k], b = (half[k] - start[k]) / along[k];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (from > to) return {};
    const auto point = [&](int i, int k) {
        return Vec3(i * dx - half[0],
                    height *
                        static_cast<double>(map.heights[static_cast<std::size_t>(k) * map.columns + static_cast<std::size_t>(i)]),
                    k * dz - half[1]);
    };
    int i = std::clamp(static_cast<int>((start[0] + from * along[0] + half[0]) / dx), 0, columns - 1);
    int k = std::clamp(static_cast<int>((start[1] + from * along[1] + half[1]) / dz), 0, rows - 1);
    const int stepI = along[0] > 0 ? 1 : -1, stepK = along[1] > 0 ? 1 : -1;
    for (int guard = 0; guard <= columns + rows + 2; ++guard) {
        const Vec3 a = point(i, k), b = point(i + 1, k), c = point(i, k + 1), d = point(i + 1, k + 1);
        const auto first = rayOnTriangle(ray, a, b, c), second = rayOnTriangle(ray, d, c, b);
        if (first && (!second || first->distance <= second->distance)) return first;
        if (second) return second;
        const double toI = std::abs(along[0]) < 1e-12 ? 1e300 : ((i + (stepI > 0)) * dx - half[0] - start[0]) / along[0];
        const double toK = std::abs(along[1]) < 1e-12 ? 1e300 : ((k + (stepK > 0)) * dz - half[1] - start[1]) / along[1];
        if (std::min(toI, toK) > to) return {};
        if (toI < toK) i += stepI;
        else k += stepK;
        if (i < 0 || k < 0 || i >= columns || k >= rows) return {};
    }
    return {};
}

} // namespace trundle
