#include "editor/viewport/tools/floor_snap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/queries/object_index.h"

namespace trundle {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kNearDirection = 4;    // degrees
constexpr double kUpright = 0.999;      // z of the normal of a wall's top
constexpr double kSlender = 2;          // length of a wall by its thickness, at least
constexpr std::size_t kMostWalls = 400; // of which corners are looked for

double angleBetween(double a, double b) { return std::abs(std::remainder(a - b, 360.)); }

double toStep(double value, double step) { return step * std::round(value / step) + 0.0; }

FloorPoint pointAt(const FloorPoint& from, double heading, double length) {
    // Exact along the axes.
    const double quarter = std::remainder(heading, 90.);
    if (std::abs(quarter) < 1e-9) {
        const int turns = static_cast<int>(std::lround(heading / 90.)) & 3;
        const double x[] = {1, 0, -1, 0}, y[] = {0, 1, 0, -1};
        return {from[0] + length * x[turns], from[1] + length * y[turns]};
    }
    return {from[0] + length * std::cos(heading * kDegree), from[1] + length * std::sin(heading * kDegree)};
}

struct MiddleLine {
    FloorPoint from{}, to{};
    double thickness = 0;
};

std::optional<MiddleLine> middleLineOf(const GeomSpec& geom, const Pose& X_WG) {
    if (geom.shape != GeomShape::Box || std::abs((X_WG.rotation * Vec3::UnitZ()).z()) < kUpright) return std::nullopt;
    const int along = geom.size.x() >= geom.size.y() ? 0 : 1;
    const double length = geom.size[along], across = geom.size[1 - along];
    if (length < kSlender * across) return std::nullopt;
    const Vec3 half = X_WG.rotation * (along == 0 ? Vec3::UnitX() : Vec3::UnitY()) * (length / 2);
    const Vec3 a = X_WG.position - half, b = X_WG.position + half;
    return MiddleLine{{a.x(), a.y()}, {b.x(), b.y()}, across};
}

/// Where they meet, if that is on both or past their ends by their thickness at most.
std::optional<FloorPoint> meeting(const MiddleLine& a, const MiddleLine& b) {
    const double ax = a.to[0] - a.from[0], ay = a.to[1] - a.from[1], bx = b.to[0] - b.from[0], by = b.to[1] - b.from[1];
    const double cross = ax * by - ay * bx, lengthA = std::hypot(ax, ay), lengthB = std::hypot(bx, by);
    if (std::abs(cross) < 0.1 * lengthA * lengthB) return std::nullopt;
    const double dx = b.from[0] - a.from[0], dy = b.from[1] - a.from[1];
    const double s = (dx * by - dy * bx) / cross, t = (dx * ay - dy * ax) / cross;
    const double pastA = std::max(a.thickness, b.thickness) / lengthA, pastB = std::max(a.thickness, b.thickness) / lengthB;
    if (s < -pastA || s > 1 + pastA || t < -pastB || t > 1 + pastB) return std::nullopt;
    return FloorPoint{a.from[0] + s * ax, a.from[1] + s * ay};
}

} // namespace

double headingBetween(const FloorPoint& from, const FloorPoint& to) {
    return std::atan2(to[1] - from[1], to[0] - from[0]) / kDegree;
}

FloorSnap snapOnFloor(const FloorPoint& cursor, const std::vector<FloorPoint>& corners, const FloorSnapOptions& options) {
    const bool snaps = options.step > 0;
    if (corners.empty()) {
        if (!snaps) return {cursor, FloorSnap::To::Nothing};
        return {{toStep(cursor[0], options.step), toStep(cursor[1], options.step)}, FloorSnap::To::Grid};
    }
    const FloorPoint& last = corners.back();
    double heading = headingBetween(last, cursor);
    FloorSnap::To to = FloorSnap::To::Nothing;
    if (options.angle) {
        heading = *options.angle, to = FloorSnap::To::Direction;
    } else if (snaps) {
        if (const double nearest = toStep(heading, options.directions); angleBetween(heading, nearest) < kNearDirection)
            heading = nearest, to = FloorSnap::To::Direction;
        if (corners.size() > 1) { // right angles to the piece before, and its own direction, go first
            const double before = headingBetween(corners[corners.size() - 2], last),
                         turn = std::remainder(heading - before, 360.);
            const double quarters = toStep(turn, 90);
            if (std::abs(turn - quarters) < kNearDirection) {
                heading = before + quarters;
                to = std::abs(quarters) == 90 ? FloorSnap::To::RightAngle : FloorSnap::To::Direction;
            }
        }
    }
    if (options.length) return {pointAt(last, heading, *options.length), to};
    const double raw = std::hypot(cursor[0] - last[0], cursor[1] - last[1]);
    if (to == FloorSnap::To::Nothing && snaps)
        return {{toStep(cursor[0], options.step), toStep(cursor[1], options.step)}, FloorSnap::To::Grid};
    const double along = raw * std::cos((headingBetween(last, cursor) - heading) * kDegree);
    return {pointAt(last, heading, std::max(0.0, snaps ? toStep(along, options.step) : along)), to};
}

std::vector<FloorPoint> wallEnds(const ObjectIndex& objects) {
    std::vector<MiddleLine> lines;
    for (const StaticSpec& fixed : objects.experiment().statics)
        if (fixed.geoms)
            for (const GeomSpec& geom : *fixed.geoms)
                if (const auto line = middleLineOf(geom, fixed.pose * geom.pose)) lines.push_back(*line);
    std::vector<FloorPoint> ends;
    const auto isNear = [&](const FloorPoint& point, double distance) {
        return std::ranges::any_of(
            ends, [&](const FloorPoint& end) { return std::hypot(end[0] - point[0], end[1] - point[1]) < distance; });
    };
    if (lines.size() <= kMostWalls)
        for (std::size_t i = 0; i < lines.size(); ++i)
            for (std::size_t k = i + 1; k < lines.size(); ++k)
                if (const auto corner = meeting(lines[i], lines[k]); corner && !isNear(*corner, 1e-6)) ends.push_back(*corner);
    const std::size_t corners = ends.size();
    for (const MiddleLine& line : lines)
        for (const FloorPoint& end : {line.from, line.to}) {
            const bool isCorner = std::any_of(ends.begin(), ends.begin() + std::ptrdiff_t(corners), [&](const FloorPoint& c) {
                return std::hypot(c[0] - end[0], c[1] - end[1]) <= line.thickness;
            });
            if (!isCorner) ends.push_back(end);
        }
    return ends;
}

} // namespace trundle
