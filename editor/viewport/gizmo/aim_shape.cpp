#include "editor/viewport/gizmo/aim_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QLineF>

#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/radio/antenna_lobes.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "scene/queries/camera_model.h"

namespace trundle {
namespace {

constexpr int kPieces = 24;               // of a line; a piece is straight on the screen as well
constexpr std::uint32_t kMostPieces = 64; // of the outline of a fan
constexpr int kCone = 8, kLobe = 36;      // lines of a cone, pieces of a great circle

void addCamera(const CameraModel& camera, const Pose& X_WB, std::vector<AimLine>& lines) {
    const Pose lens = X_WB * camera.mounting;
    const double wide = std::tan(0.5 * camera.fieldOfView), high = wide * camera.height / std::max(1u, camera.width);
    const auto corner = [&](double depth, int i) {
        const double left = i == 0 || i == 3 ? 1 : -1, up = i < 2 ? 1 : -1;
        return Vec3(lens * Vec3(depth, left * wide * depth, up * high * depth));
    };
    for (int i = 0; i < 4; ++i) {
        lines.push_back({corner(camera.nearPlane, i), corner(camera.farPlane, i)});
        lines.push_back({corner(camera.farPlane, i), corner(camera.farPlane, (i + 1) % 4)});
    }
}

void addBeams(const RangeModel& sensor, const Pose& X_WB, std::vector<AimLine>& lines) {
    const Pose eye = X_WB * sensor.mounting;
    if (sensor.ground) return;
    if (sensor.beams > 0) { // the outline of each layer
        const auto end = [&](std::uint32_t layer, std::uint32_t beam) {
            return Vec3(eye * (sensor.maxRange * sensor.directions[std::size_t(layer) * sensor.beams + beam]));
        };
        const std::uint32_t step = sensor.beams / kMostPieces + 1;
        for (std::uint32_t layer = 0; layer < sensor.layers; ++layer) {
            for (std::uint32_t i = 0; i + 1 < sensor.beams; i += step)
                lines.push_back({end(layer, i), end(layer, std::min(i + step, sensor.beams - 1))});
            if (!sensor.closed)
                for (const std::uint32_t i : {0u, sensor.beams - 1}) lines.push_back({eye.position, end(layer, i)});
        }
        return;
    }
    const double half = sensor.coneAngle / 2;
    for (int i = 0; i < kCone; ++i) {
        const double around = 2 * std::numbers::pi * i / kCone;
        lines.push_back({eye.position, eye * (sensor.maxRange * Vec3(std::cos(half), std::sin(half) * std::cos(around),
                                                                     std::sin(half) * std::sin(around)))});
    }
}

void addLobe(const RadioNode& node, double unit, const Pose& X_WB, std::vector<AimLine>& lines) {
    const Pose antenna = X_WB * node.mounting;
    const AntennaPattern isotropic;
    const AntennaPattern& pattern = node.radio.antenna ? *node.radio.antenna : isotropic;
    for (int plane = 0; plane < 3; ++plane) {
        const auto at = [&](int i) {
            const double angle = 2 * std::numbers::pi * i / kLobe;
            const Vec3 way = std::cos(angle) * Vec3::Unit(plane) + std::sin(angle) * Vec3::Unit((plane + 1) % 3);
            return Vec3(antenna * (lobeRadius(pattern.gain(way), unit) * way));
        };
        for (int i = 0; i < kLobe; ++i) lines.push_back({at(i), at(i + 1)});
    }
}

} // namespace

std::vector<AimLine> aimShapeOf(const ToolView& view, const std::string& device) {
    const ViewportScene& world = view.context().world;
    const BodyPoses& poses = view.shownPoses();
    std::vector<AimLine> lines;
    for (const CameraModel* camera : world.camerasOf(device))
        if (camera->body < poses.size() && camera != view.camera().through()) addCamera(*camera, poses[camera->body], lines);
    for (const RangeModel& sensor : world.rangeSensors())
        if (sensor.body < poses.size() && world.isPartOf(device, sensor.robot, sensor.body, sensor.path))
            addBeams(sensor, poses[sensor.body], lines);
    const RadioOverlays* radios = view.context().radios;
    if (!radios || radios->lobeUnit() <= 0) return lines;
    for (const RadioNode& node : radios->nodes())
        if (node.body < poses.size() && world.isPartOf(device, node.robot, node.body, node.radio.path))
            addLobe(node, radios->lobeUnit(), poses[node.body], lines);
    return lines;
}

std::optional<Vec3> pointUnder(const ToolView& view, const std::vector<AimLine>& lines, const QPointF& at, double reach) {
    std::optional<Vec3> nearest;
    for (const auto& [a, b] : lines) {
        std::optional<QPointF> before;
        for (int i = 0; i <= kPieces; ++i) {
            const Vec3 point = a + double(i) / kPieces * (b - a);
            const auto pixel = view.camera().pixelOf(point);
            if (pixel && before) {
                const QPointF along = *pixel - *before, from = at - *before;
                const double length = QPointF::dotProduct(along, along);
                const double t = length > 0 ? std::clamp(QPointF::dotProduct(from, along) / length, 0.0, 1.0) : 0;
                const double distance = QLineF(at, *before + t * along).length();
                if (distance < reach) reach = distance, nearest = a + (i - 1 + t) / kPieces * (b - a);
            }
            before = pixel;
        }
    }
    return nearest;
}

} // namespace trundle
