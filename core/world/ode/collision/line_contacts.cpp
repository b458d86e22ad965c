#include "world/ode/collision/line_contacts.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kOnFace = 0.99;    // cosine between a contact's normal and that of the face which it is on
constexpr double kSameFace = 0.999; // cosine between triangles of one face
constexpr double kLying = 0.3;      // cosine between axis and normal: what leans more touches with an end
constexpr double kParallel = 0.05;  // sine of the angle between two axes
constexpr double kShortest = 1e-6;  // m: of a line that has two ends

/// Of a line from `from` to `to` the part within all faces but the one it lies on; `lo` above `hi`: no part of it.
void clipLine(const FlatBody& body, std::size_t face, const Vec3& from, const Vec3& to, double& lo, double& hi) {
    for (std::size_t k = 0; k < body.normals.size(); ++k) {
        const double along = body.normals[k].dot(body.normals[face]);
        if (along > kSameFace || along < -kOnFace) continue; // what it came through is not a side
        const double a = body.normals[k].dot(from) - body.offsets[k], b = body.normals[k].dot(to) - body.offsets[k];
        if (a > 0 && b > 0) hi = -1;
        else if (a > 0) lo = std::max(lo, a / (a - b));
        else if (b > 0) hi = std::min(hi, a / (a - b));
    }
}

} // namespace

bool sideOnFace(const RoundSide& side, const FlatBody& body, const Vec3& normal, std::vector<SurfaceContact>& contacts) {
    std::size_t face = 0;
    for (std::size_t k = 1; k < body.normals.size(); ++k)
        if (body.normals[k].dot(normal) > body.normals[face].dot(normal)) face = k;
    if (body.normals.empty() || body.normals[face].dot(normal) < kOnFace) return false;
    const Vec3& out = body.normals[face];
    const double along = out.dot(side.axis);
    if (std::abs(along) > kLying) return false;
    const Vec3 reach = side.radius * (side.hasRoundEnds ? out : Vec3((out - along * side.axis).normalized()));
    const Vec3 from = side.centre - side.half * side.axis - reach, to = side.centre + side.half * side.axis - reach;
    double lo = 0, hi = 1;
    clipLine(body, face, from, to, lo, hi);
    if (hi < lo) return false;
    const std::size_t before = contacts.size();
    const bool hasTwo = (hi - lo) * 2 * side.half > kShortest;
    for (const double t : {lo, hi}) {
        const Vec3 at = from + t * (to - from);
        const double depth = body.offsets[face] - out.dot(at);
        if (depth >= 0 && (t == lo || hasTwo)) contacts.push_back({at, out, depth});
    }
    return contacts.size() > before;
}

bool sideOnSide(const RoundSide& first, const RoundSide& second, const Vec3& normal, std::vector<SurfaceContact>& contacts) {
    if (first.axis.cross(second.axis).norm() > kParallel) return false;
    const double along = first.axis.dot(second.axis), aside = first.axis.dot(second.centre - first.centre);
    const double reach = second.half * std::abs(along);
    const double lo = std::max(-first.half, aside - reach), hi = std::min(first.half, aside + reach);
    if (hi - lo < kShortest) return false;
    const std::size_t before = contacts.size();
    for (const double t : {lo, hi}) {
        const Vec3 own = first.centre + t * first.axis, other = second.centre + (t - aside) / along * second.axis;
        const Vec3 apart = own - other;
        const double distance = apart.norm(), depth = first.radius + second.radius - distance;
        if (depth >= 0 && apart.dot(normal) > kOnFace * distance)
            contacts.push_back({own - (first.radius - depth / 2) / distance * apart, apart / distance, depth});
    }
    return contacts.size() > before;
}

} // namespace trundle
