#include "scene/queries/sun_fit.h"

#include <array>
#include <tuple>

namespace trundle {
namespace {

constexpr double kLeastSunHeight = 0.2; // z of the unit vector towards the sun; with a lower sun, shadows are cut off
constexpr double kSunRoom = 0.02;       // fraction of the box, margin for the blur at its edge
constexpr double kSunSteps = 4;         // steps per doubling of the size

/// World box -> bounds along the sun's axes.
Bounds turned(const Mat3& axes, const Bounds& box) {
    Bounds result;
    for (int i = 0; i < 8; ++i) result.add(axes.transpose() * box.corner(i));
    return result;
}

bool overlap(const Bounds& a, const Bounds& b) {
    return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() && b.low.y() <= a.high.y();
}

/// Bounds along the sun's axes of the view frustum, as far as objects and the ground that receives their shadows can be seen.
Bounds shown(const Mat3& axes, const Bounds& all, const CameraView& view, double aspect) {
    const Mat3 camera = cameraAxes(view);
    const double shadow = all.size().z() / std::max(kLeastSunHeight, axes(2, 2));
    double reach = 0.01;
    for (int i = 0; i < 8; ++i) reach = std::max(reach, camera.col(2).dot(view.eye - all.corner(i)) + shadow);
    Bounds seen;
    for (const double distance : {0.0, reach}) {
        const double half =
            view.orthographicWidth > 0 ? 0.5 * view.orthographicWidth : distance * std::tan(0.5 * view.fieldOfView);
        for (const auto& [x, y] : std::array<std::pair<int, int>, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) {
            const Vec3 corner = view.eye + camera * Vec3(x * half, y * half * aspect, -distance);
            seen.add(axes.transpose() * corner);
        }
    }
    return seen;
}

/// The interval [low, high], enlarged slightly and snapped to size steps and to a pixel grid.
std::pair<double, double> steady(double low, double high, std::uint32_t pixels) {
    const double wanted = std::max(1e-3, (high - low) * (1 + 2 * kSunRoom));
    const double size = std::exp2(std::ceil(kSunSteps * std::log2(wanted * (1 + 2.0 / pixels))) / kSunSteps),
                 pixel = size / pixels;
    return {std::floor((0.5 * (low + high - size)) / pixel) * pixel, size};
}

} // namespace

std::optional<SunFit> fitSun(const Vec3& sun, const std::vector<Bounds>& casters, const CameraView& view, std::uint32_t width,
                             std::uint32_t height, std::uint32_t pixels) {
    SunFit fit;
    const Vec3 right = (std::abs(sun.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX()).cross(sun).normalized();
    fit.axes << right, sun.cross(right), sun;
    Bounds all;
    for (const Bounds& box : casters)
        if (!box.empty()) all.add(box);
    if (all.empty()) return std::nullopt;
    const Bounds seen = shown(fit.axes, all, view, double(height) / std::max(1u, width));
    Bounds kept;
    for (const Bounds& box : casters) {
        if (box.empty()) continue;
        const Bounds along = turned(fit.axes, box);
        if (overlap(along, seen)) kept.add(along);
    }
    if (kept.empty()) return std::nullopt;
    for (int i = 0; i < 2; ++i) {
        kept.low[i] = std::max(kept.low[i], seen.low[i]);
        kept.high[i] = std::min(kept.high[i], seen.high[i]);
    }
    std::tie(fit.origin.x(), fit.width) = steady(kept.low.x(), kept.high.x(), pixels);
    std::tie(fit.origin.y(), fit.height) = steady(kept.low.y(), kept.high.y(), pixels);
    fit.depth = (kept.high.z() - kept.low.z()) * (1 + 2 * kSunRoom) + 0.01;
    fit.origin.z() = kept.high.z() + kSunRoom * (kept.high.z() - kept.low.z()) + 0.005;
    return fit;
}

} // namespace trundle
