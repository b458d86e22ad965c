#include "editor/viewport/overlays/springs.h"

#include <cmath>
#include <numbers>

#include <QPainter>

#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/selected_names.h"

namespace trundle {
namespace {

constexpr std::size_t kMostRobots = 300;
constexpr int kTurns = 8, kSteps = 10;                              // points of a turn
constexpr double kSlim = 0.06, kThinnest = 0.003, kThickest = 0.03; // radius: share of the natural length; m
const QColor kSteel(196, 204, 214), kOutline(10, 12, 16, 150);

/// A helix with straight ends, in the world.
QPolygonF coil(const ToolView& view, const Vec3& from, const Vec3& to, double radius) {
    const Vec3 along = to - from;
    if (along.norm() < 1e-6) return {};
    const Vec3 side = along.unitOrthogonal(), other = along.normalized().cross(side);
    QPolygonF points;
    const auto add = [&](const Vec3& place) {
        if (const auto at = view.shownPixelOf(place)) points << *at;
    };
    add(from);
    for (int i = 0; i <= kTurns * kSteps; ++i) {
        const double share = double(i) / (kTurns * kSteps), angle = 2 * std::numbers::pi * i / kSteps,
                     wide = radius * std::min(1.0, 8 * std::min(share, 1 - share));
        add(from + (0.1 + 0.8 * share) * along + wide * (std::cos(angle) * side + std::sin(angle) * other));
    }
    add(to);
    return points;
}

void paintCoil(QPainter& painter, const ToolView& view, const SpringSpec& spring, const Vec3& from, const Vec3& to,
               bool selected) {
    const QPolygonF points = coil(view, from, to, std::clamp(kSlim * spring.length, kThinnest, kThickest));
    painter.setPen(QPen(kOutline, selected ? 4.4 : 3.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(points);
    painter.setPen(
        QPen(selected ? ToolView::outlineColour() : kSteel, selected ? 2.2 : 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(points);
}

/// Those between robots.
void paintLinkedSprings(QPainter& painter, const ToolView& view) {
    const ViewportScene& world = view.context().world;
    const ExperimentSpec& experiment = world.objects()->experiment();
    for (const auto& link : experiment.springs) {
        const auto shown = [&](int robot, int body, const Vec3& point) -> Vec3 {
            if (robot == kWorldBody) return point;
            const auto r = std::uint32_t(robot), b = std::uint32_t(body);
            const Pose start = experiment.robots[r].pose * experiment.robots[r].config->bodies[b].pose;
            return world.objects()->poseOf({ObjectKind::Body, r, b}, view.shownPoses()) * (start.inverse() * point);
        };
        paintCoil(painter, view, link.spec, shown(link.parentRobot, link.spec.parent, link.spec.anchor),
                  shown(link.childRobot, link.spec.child, link.spec.anchor2), isSelected(view.context(), link.spec.name));
    }
}

} // namespace

void paintSprings(QPainter& painter, const ToolView& view) {
    const ViewportScene& world = view.context().world;
    const Selection& selection = view.context().selection;
    const auto& robots = world.objects()->experiment().robots;
    painter.setBrush(Qt::NoBrush);
    paintLinkedSprings(painter, view);
    for (std::uint32_t r = 0; r < robots.size() && r < kMostRobots; ++r) {
        if (!robots[r].config || robots[r].config->springs.empty() || world.isHidden({ObjectKind::Robot, r})) continue;
        const RobotConfigSpec& config = *robots[r].config;
        const auto shown = [&](int body, const Vec3& point) -> Vec3 {
            if (body == kWorldBody) return robots[r].pose * point;
            const auto index = std::uint32_t(body);
            return world.objects()->poseOf({ObjectKind::Body, r, index}, view.shownPoses()) *
                   (config.bodies[index].pose.inverse() * point);
        };
        for (const SpringSpec& spring : config.springs) {
            const std::string name = robots[r].name + "." + spring.name;
            const bool selected = isSelected(view.context(), name, isNameOfAny(robots[r], config.springs)) ||
                                  selection.contains("RobotConfig." + config.name + "." + spring.name);
            paintCoil(painter, view, spring, shown(spring.parent, spring.anchor), shown(spring.child, spring.anchor2), selected);
        }
    }
}

} // namespace trundle
