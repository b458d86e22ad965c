#include "editor/viewport/overlays/mass_overlay.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <QCoreApplication>
#include <QPainter>

#include "editor/document/selection.h"
#include "editor/viewport/context/label.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"
#include "lang/number_text.h"
#include "scene/queries/balance.h"

namespace trundle {
namespace {

constexpr std::size_t kMostCentres = 300, kMostShown = 40; // robots
constexpr int kEllipseSteps = 48;
constexpr double kTipPixels = 18,
                 kLeastTipPixels = 24; // of the labels from the edge; of the polygon's half that has room for them
const QColor kInertiaInk(90, 190, 255), kStable(70, 200, 110), kUnstable(240, 90, 80), kMassDark(20, 22, 26);

QString trMass(const char* text) { return QCoreApplication::translate("MassOverlay", text); }

QString figure(double value, double step) { return QString::fromStdString(steppedNumber(value, step)); }

void paintCentre(QPainter& painter, const QPointF& at, double radius) {
    painter.setPen(QPen(kMassDark, 1.2));
    painter.setBrush(Qt::white);
    painter.drawEllipse(at, radius, radius);
    painter.setBrush(kMassDark);
    const QRectF box(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
    painter.drawPie(box, 0, 90 * 16);
    painter.drawPie(box, 180 * 16, 90 * 16);
}

/// Robots that have mass and are not hidden.
std::vector<std::uint32_t> shownRobots(const ViewportScene& world, std::size_t most) {
    std::vector<std::uint32_t> shown;
    const auto& robots = world.objects()->experiment().robots;
    for (std::uint32_t r = 0; r < robots.size() && shown.size() < most; ++r)
        if (robots[r].config && !robots[r].scenery && !world.isHidden({ObjectKind::Robot, r})) shown.push_back(r);
    return shown;
}

/// `mass` in the frame that is at X_W.
void paintEllipsoid(QPainter& painter, const ToolView& view, const MassProperties& mass, const Pose& X_W) {
    if (!(mass.mass > 0)) return;
    const InertiaEllipsoid ellipsoid = ellipsoidOf(mass);
    const Vec3 centre = X_W * mass.centre;
    const Mat3 axes = X_W.rotation.toRotationMatrix() * ellipsoid.axes;
    for (int k = 0; k < 3; ++k) {
        const Vec3 u = ellipsoid.semiAxes[k] * axes.col(k), v = ellipsoid.semiAxes[(k + 1) % 3] * axes.col((k + 1) % 3);
        QPolygonF ring;
        for (int i = 0; i <= kEllipseSteps; ++i) {
            const double angle = 2 * std::numbers::pi * i / kEllipseSteps;
            if (const auto at = view.shownPixelOf(centre + std::cos(angle) * u + std::sin(angle) * v)) ring << *at;
        }
        painter.setBrush(Qt::NoBrush);
        for (const auto& [colour, width] : {std::pair(QColor(10, 12, 16, 90), 3.0), {kInertiaInk, 1.4}}) {
            painter.setPen(QPen(colour, width));
            painter.drawPolyline(ring);
        }
    }
    const auto at = view.shownPixelOf(centre);
    if (!at) return;
    paintCentre(painter, *at, 4);
    const QString weight =
        mass.mass < 0.1 ? trMass("%1 g").arg(figure(mass.mass * 1000, 0.01)) : trMass("%1 kg").arg(figure(mass.mass, 1e-3));
    paintLabel(painter, *at + QPointF(0, -18), weight);
}

/// What is selected; a whole config and an instance are a robot.
std::vector<ObjectRef> massesToShow(const ToolView& view) {
    const ViewportScene& world = view.context().world;
    std::vector<ObjectRef> shown;
    for (const std::string& path : view.context().selection.paths())
        for (ObjectRef object : world.objectsOf(path)) {
            if (object.kind == ObjectKind::Geom) object = *world.objects()->ownerOf(object);
            if (object.kind == ObjectKind::Body || object.kind == ObjectKind::Robot) shown.push_back(object);
        }
    if (!shown.empty()) return shown;
    for (const std::uint32_t robot : shownRobots(world, kMostShown)) shown.push_back({ObjectKind::Robot, robot});
    return shown;
}

/// At the edge in each direction, the slope on which the robot turns over.
void paintTipping(QPainter& painter, const ToolView& view, const Balance& balance, const Quat& rotation) {
    const ScenePainter scene(painter, view);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
        Vec3 direction = rotation * axis;
        direction.z() = 0;
        if (direction.norm() < 1e-3) continue;
        const Vec3 edge = edgeTowards(balance, direction);
        scene.line(balance.centre, edge, kStable, 1, Qt::DotLine);
        const QString angle = figure(tipAngle(balance, direction) * 180 / std::numbers::pi, 1) + QStringLiteral("°");
        const auto from = view.shownPixelOf(balance.centre), at = view.shownPixelOf(edge);
        if (!from || !at) continue;
        const QPointF out = *at - *from;
        const double length = std::hypot(out.x(), out.y());
        if (length > kLeastTipPixels) paintLabel(painter, *at + out * (kTipPixels / length), angle);
    }
}

void paintBalance(QPainter& painter, const ToolView& view, const Balance& balance, const Quat& rotation) {
    const QColor colour = balance.isStable() ? kStable : kUnstable;
    const ScenePainter scene(painter, view);
    std::vector<Vec3> polygon = balance.polygon;
    for (Vec3& p : polygon) p.z() += 1e-3; // above the ground
    if (polygon.size() > 2) {
        QColor fill = colour;
        fill.setAlpha(60);
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        scene.polygon(polygon);
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) scene.line(polygon[i], polygon[(i + 1) % polygon.size()], colour, 2);
    scene.dots(polygon, colour, 6);
    scene.line(balance.centre, balance.centre + balance.height * Vec3::UnitZ(), QColor(245, 246, 248), 1, Qt::DashLine);
    if (balance.isStable()) paintTipping(painter, view, balance, rotation);
    const auto at = view.shownPixelOf(balance.centre);
    if (!at) return;
    painter.setPen(QPen(kMassDark, 1.2));
    painter.setBrush(colour);
    painter.drawEllipse(*at, 4.5, 4.5);
    paintLabel(painter, *at + QPointF(0, 18), QString::fromStdString(balanceText(balance)));
}

} // namespace

void paintCentresOfMass(QPainter& painter, const ToolView& view) {
    const ViewportScene& world = view.context().world;
    for (const std::uint32_t r : shownRobots(world, kMostCentres)) {
        const auto& bodies = world.objects()->experiment().robots[r].config->bodies;
        for (std::uint32_t b = 0; b < bodies.size() && bodies.size() > 1; ++b) {
            const Pose body = world.objects()->poseOf({ObjectKind::Body, r, b}, view.shownPoses());
            if (const auto at = view.shownPixelOf(body * bodies[b].mass.centre)) paintCentre(painter, *at, 3.2);
        }
        const MassProperties whole = massOf(*world.objects(), r, view.shownPoses());
        if (const auto at = whole.mass > 0 ? view.shownPixelOf(whole.centre) : std::nullopt) paintCentre(painter, *at, 6.5);
    }
}

void paintInertia(QPainter& painter, const ToolView& view) {
    const ViewportScene& world = view.context().world;
    for (const ObjectRef& object : massesToShow(view)) {
        const RobotSpec& robot = *world.objects()->robotOf(object);
        if (!robot.config || world.isHidden(object)) continue;
        if (object.kind == ObjectKind::Body)
            paintEllipsoid(painter, view, robot.config->bodies[object.body].mass,
                           world.objects()->poseOf(object, view.shownPoses()));
        else paintEllipsoid(painter, view, massOf(*world.objects(), object.instance, view.shownPoses()), {});
    }
}

void paintSupport(QPainter& painter, const ToolView& view) {
    const ViewportScene& world = view.context().world;
    const Vec3& gravity = world.objects()->experiment().settings.gravity;
    if (gravity.z() >= 0 || gravity.head<2>().norm() > 1e-3 * gravity.norm()) return; // the ground would not be level
    for (const std::uint32_t r : shownRobots(world, kMostShown)) {
        const auto balance = balanceOf(*world.objects(), r, view.shownPoses());
        if (!balance) continue;
        const Pose& first = world.objects()->experiment().robots[r].config->bodies.front().pose;
        const Quat rotation =
            world.objects()->poseOf({ObjectKind::Body, r, 0}, view.shownPoses()).rotation * first.rotation.conjugate();
        paintBalance(painter, view, *balance, rotation);
    }
}

} // namespace trundle
