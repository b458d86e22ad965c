#include "scene/queries/camera_view.h"

namespace trundle {
namespace {

constexpr double kHeading = -62 * std::numbers::pi / 180; // rad; the eye is in front of the scene, slightly towards +x
constexpr double kElevation = 33 * std::numbers::pi / 180;
constexpr double kRoom = 0.93; // fraction of the image that the bounds may fill

double focalLength(const CameraView& view, double width) { return 0.5 * width / std::tan(0.5 * view.fieldOfView); }

} // namespace

bool isUsable(const CameraView& view) {
    return view.eye.allFinite() && view.target.allFinite() && view.up.allFinite() && (view.eye - view.target).norm() > 1e-9 &&
           view.eye.norm() < 1e7 && view.target.norm() < 1e7 && view.fieldOfView > 1e-3 &&
           view.fieldOfView < std::numbers::pi - 1e-3 && std::isfinite(view.orthographicWidth) && std::isfinite(view.nearPlane) &&
           std::isfinite(view.farPlane) && view.orthographicWidth >= 0 && view.nearPlane >= 0 && view.farPlane >= 0 &&
           (view.nearPlane == 0 || view.farPlane == 0 || view.nearPlane < view.farPlane);
}

CameraView settled(const CameraView& view) {
    const auto rounded = [](const Vec3& v) -> Vec3 {
        constexpr double kParts = 1 << 20; // of a metre
        return (v * kParts).array().round() / kParts;
    };
    CameraView result = view;
    result.eye = rounded(view.eye);
    result.target = result.eye + rounded(view.target - view.eye);
    result.up = rounded(view.up);
    return result;
}

Mat3 cameraAxes(const CameraView& view) {
    const Vec3 back = (view.eye - view.target).normalized();
    Vec3 right = view.up.cross(back);
    if (right.norm() < 1e-6 * std::max(view.up.norm(), 1e-12))
        right = (std::abs(back.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX()).cross(back);
    right.normalize();
    Mat3 axes;
    axes << right, back.cross(right), back;
    return axes;
}

std::optional<ImagePoint> project(const CameraView& view, std::uint32_t width, std::uint32_t height, const Vec3& point) {
    const Vec3 p = cameraAxes(view).transpose() * (point - view.eye);
    const double depth = -p.z();
    if (!(depth > 0)) return std::nullopt;
    const double pixelsPerMetre = view.orthographicWidth > 0 ? width / view.orthographicWidth : focalLength(view, width) / depth;
    return ImagePoint{0.5 * width + p.x() * pixelsPerMetre, 0.5 * height - p.y() * pixelsPerMetre, depth};
}

ViewRay rayThrough(const CameraView& view, std::uint32_t width, std::uint32_t height, double x, double y) {
    const Mat3 axes = cameraAxes(view);
    const double right = x - 0.5 * width, up = 0.5 * height - y;
    if (view.orthographicWidth > 0) {
        const double metresPerPixel = view.orthographicWidth / width;
        return {view.eye + axes * Vec3(right * metresPerPixel, up * metresPerPixel, 0), -axes.col(2)};
    }
    return {view.eye, (axes * Vec3(right, up, -focalLength(view, width))).normalized()};
}

CameraView viewOf(const Bounds& bounds, std::uint32_t width, std::uint32_t height) {
    Bounds box = bounds;
    if (box.empty()) box = {Vec3(-1, -1, 0), Vec3(1, 1, 0.5)}; // empty floor: leave room for objects
    if (box.radius() < 0.05) box.grow(0.05);
    CameraView view;
    view.fieldOfView = 45 * std::numbers::pi / 180;
    const Vec3 back{std::cos(kHeading) * std::cos(kElevation), std::sin(kHeading) * std::cos(kElevation), std::sin(kElevation)};
    view.target = box.centre();
    const double halfWidth = std::tan(0.5 * view.fieldOfView) * kRoom;
    const double halfHeight = halfWidth * height / std::max(1u, width);

    // Moves the eye back until every corner is inside the image, then centres the target on the projected corners; repeated.
    for (int round = 0; round < 4; ++round) {
        view.eye = view.target + back;
        const Mat3 axes = cameraAxes(view);
        double distance = 0;
        for (int i = 0; i < 8; ++i) {
            const Vec3 p = axes.transpose() * (box.corner(i) - view.target);
            distance = std::max({distance, p.z() + std::abs(p.x()) / halfWidth, p.z() + std::abs(p.y()) / halfHeight});
        }
        view.eye = view.target + back * distance;
        if (round == 3) break;
        double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
        for (int i = 0; i < 8; ++i) {
            const Vec3 p = axes.transpose() * (box.corner(i) - view.eye);
            left = std::min(left, p.x() / -p.z()), right = std::max(right, p.x() / -p.z());
            low = std::min(low, p.y() / -p.z()), high = std::max(high, p.y() / -p.z());
        }
        view.target += axes.col(0) * (0.5 * (left + right) * distance) + axes.col(1) * (0.5 * (low + high) * distance);
    }
    return view;
}

} // namespace trundle
