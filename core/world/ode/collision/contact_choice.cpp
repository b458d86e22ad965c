#include "world/ode/collision/contact_choice.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr double kSameDirection = 0.9;
constexpr double kDepthBand = 1e-4; // m
constexpr double kLeastArea = 1e-6; // of the square of its length: a patch with less is a line

double dot3(const dReal* a, const dReal* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool isSound(const dContactGeom& c) {
    const double n = dot3(c.normal, c.normal);
    return std::isfinite(c.depth) && c.depth >= 0 && n > 0.9 && n < 1.1 && std::isfinite(c.pos[0] + c.pos[1] + c.pos[2]);
}

double distance2(const dContactGeom& a, const dContactGeom& b) {
    double d = 0;
    for (int k = 0; k < 3; ++k) d += (a.pos[k] - b.pos[k]) * (a.pos[k] - b.pos[k]);
    return d;
}

} // namespace

int takeDirection(const dContactGeom* found, int count, UsedPoints& used, PointGroup& group) {
    int size = 0;
    for (int i = 0; i < count; ++i) {
        if (used[static_cast<std::size_t>(i)] || !isSound(found[i])) continue;
        if (size > 0 && dot3(found[i].normal, found[group[0]].normal) < kSameDirection) continue;
        used[static_cast<std::size_t>(i)] = true;
        group[static_cast<std::size_t>(size++)] = i;
    }
    return size;
}

int spread(const dContactGeom* found, PointGroup& group, int count, int most) {
    for (int chosen = 0; chosen < std::min(count, most); ++chosen) {
        int best = chosen;
        double bestValue = -1;
        for (int i = chosen; i < count; ++i) {
            double value = found[group[static_cast<std::size_t>(i)]].depth;
            if (chosen > 0) {
                value = dInfinity;
                for (int k = 0; k < chosen; ++k)
                    value = std::min(
                        value, distance2(found[group[static_cast<std::size_t>(i)]], found[group[static_cast<std::size_t>(k)]]));
            }
            if (value > bestValue) {
                bestValue = value;
                best = i;
            }
        }
        if (chosen > 0 && bestValue < 1e-12) return chosen; // the same point twice
        std::rotate(group.begin() + chosen, group.begin() + best, group.begin() + best + 1);
    }
    return std::min(count, most);
}

namespace {

Vec3 placeOf(const dContactGeom& c) { return vec(c.pos); }

/// m^2: what a point adds to the area of up to three others.
double areaGained(std::span<const Vec3> others, const Vec3& point) {
    if (others.size() < 3) return (point - others[0]).cross(others[1] - others[0]).norm();
    const Vec3 normal = (others[1] - others[0]).cross(others[2] - others[0]).normalized();
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &a = others[i], &b = others[(i + 1) % 3];
        most = std::max(most, -(b - a).cross(point - a).dot(normal));
    }
    return most;
}

} // namespace

int spreadWidely(const dContactGeom* found, PointGroup& group, int count, int most) {
    const int two = spread(found, group, count, std::min(most, 2));
    if (two < 2) return two;
    std::vector<Vec3> chosen{placeOf(found[group[0]]), placeOf(found[group[1]])};
    for (int next = 2; next < std::min(count, std::min(most, 4)); ++next) {
        int best = next;
        double widest = -1;
        for (int i = next; i < count; ++i) {
            const double gained = areaGained(chosen, placeOf(found[group[static_cast<std::size_t>(i)]]));
            if (gained > widest) widest = gained, best = i;
        }
        if (widest < kLeastArea * (chosen[1] - chosen[0]).squaredNorm()) return next;
        std::rotate(group.begin() + next, group.begin() + best, group.begin() + best + 1);
        chosen.push_back(placeOf(found[group[static_cast<std::size_t>(next)]]));
    }
    return std::min(count, std::min(most, 4));
}

int takeGround(const dContactGeom* found, int count, UsedPoints& used, Vec3& normal) {
    int deepest = -1;
    for (int i = 0; i < count; ++i)
        if (!used[static_cast<std::size_t>(i)] && isSound(found[i]) && (deepest < 0 || found[i].depth > found[deepest].depth))
            deepest = i;
    if (deepest < 0) return -1;
    const dContactGeom& top = found[deepest];
    normal.setZero();
    for (int i = 0; i < count; ++i) {
        if (used[static_cast<std::size_t>(i)] || dot3(found[i].normal, top.normal) < kSideHit) continue;
        used[static_cast<std::size_t>(i)] = true;
        if (isSound(found[i]) && found[i].depth > top.depth - kDepthBand) normal += vec(found[i].normal);
    }
    used[static_cast<std::size_t>(deepest)] = true;
    normal.normalize();
    return deepest;
}

} // namespace trundle
