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

/// A robot that rests on level ground.
struct Resting {
    Balance balance;
    Quat rotation; ///< of the robot
};

std::vector<Resting> restingRobots(const ToolView& view) {
    std::vector<Resting> all;
    const ViewportScene& world = view.context().world;
    const Vec3& gravity = world.objects()->experiment().settings.gravity;
    if (gravity.z() >= 0 || gravity.head<2>().norm() > 1e-3 * gravity.norm()) return all; // the ground would not be level
    for (const std::uint32_t r : shownRobots(world, kMostShown)) {
        auto balance = balanceOf(*world.objects(), r, view.shownPoses());
        if (!balance) continue;
        const Pose& first = world.objects()->experiment().robots[r].config->bodies.front().pose;
        const Quat now = world.objects()->poseOf({ObjectKind::Body, r, 0}, view.shownPoses()).rotation;
        all.push_back({std::move(*balance), now * first.rotation.conjugate()});
    }
    return all;
}

int degrees(double angle) { return int(std::lround(angle * 180 / std::numbers::pi)); }

/// A direction in which the robot turns over on a slope.
struct Tipping {
    Vec3 edge;
    int angle = 0; ///< degrees, of that slope
    bool isNearest = false;
};

/// Forward, backward, left and right, and to the nearest edge if it is another one.
std::vector<Tipping> tippingsOf(const Resting& robot) {
    std::vector<Tipping> all;
    const Balance& balance = robot.balance;
    const int least = degrees(leastTipAngle(balance));
    bool hasNearest = false;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
        Vec3 direction = robot.rotation * axis;
        direction.z() = 0;
        if (direction.norm() < 1e-3) continue;
        const int angle = degrees(tipAngle(balance, direction));
        all.push_back({edgeTowards(balance, direction), angle, angle == least && !hasNearest});
        hasNearest = hasNearest || angle == least;
    }
    if (!hasNearest) all.push_back({nearestEdge(balance), least, true});
    return all;
}

/// Beyond the edge, then further out, then beside that.
void addTippingLabels(const ToolView& view, const Resting& robot, std::vector<LabelRequest>& labels) {
    const auto from = view.shownPixelOf(robot.balance.centre);
    for (const Tipping& tipping : tippingsOf(robot)) {
        const auto at = view.shownPixelOf(tipping.edge);
        if (!from || !at) continue;
        const QPointF way = *at - *from;
        const double length = std::hypot(way.x(), way.y());
        if (length <= kLeastTipPixels && !tipping.isNearest) continue;
        const QPointF out = length > 1 ? way / length : QPointF(0, -1), beside(-out.y(), out.x());
        LabelRequest label{QStringLiteral("%1°").arg(tipping.angle), {}, tipping.isNearest};
        for (const double aside : {0.0, 1.0, -1.0})
            for (const double steps : {1.0, 2.0, 3.0})
                label.places.push_back(*at + kTipPixels * (steps * out + 2 * aside * beside));
        labels.push_back(std::move(label));
    }
}

void addBalanceLabel(const ToolView& view, const Balance& balance, std::vector<LabelRequest>& labels) {
    const auto at = view.shownPixelOf(balance.centre);
    if (!at) return;
    LabelRequest label{QString::fromStdString(balanceText(balance)), {}, true};
    for (const double below : {1.0, -1.0, 2.5, -2.5, 4.0, -4.0, 5.5, -5.5})
        label.places.push_back(*at + QPointF(0, below * kTipPixels));
    labels.push_back(std::move(label));
}

void paintBalance(QPainter& painter, const ToolView& view, const Resting& robot) {
    const Balance& balance = robot.balance;
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
    if (balance.isStable())
        for (const Tipping& tipping : tippingsOf(robot))
            scene.line(balance.centre, tipping.edge, kStable, tipping.isNearest ? 2 : 1,
                       tipping.isNearest ? Qt::SolidLine : Qt::DotLine);
    const auto at = view.shownPixelOf(balance.centre);
    if (!at) return;
    painter.setPen(QPen(kMassDark, 1.2));
    painter.setBrush(colour);
    painter.drawEllipse(*at, 4.5, 4.5);
}

std::vector<PlacedLabel> labelsOf(const std::vector<Resting>& robots, const ToolView& view) {
    std::vector<LabelRequest> labels;
    for (const Resting& robot : robots) {
        if (robot.balance.isStable()) addTippingLabels(view, robot, labels);
        addBalanceLabel(view, robot.balance, labels);
    }
    return placeLabels(labels, QFontMetricsF(view.widget().font()), view.widget().rect());
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

std::vector<PlacedLabel> supportLabels(const ToolView& view) { return labelsOf(restingRobots(view), view); }

void paintSupport(QPainter& painter, const ToolView& view) {
    const std::vector<Resting> robots = restingRobots(view);
    for (const Resting& robot : robots) paintBalance(painter, view, robot);
    for (const PlacedLabel& label : labelsOf(robots, view)) paintLabel(painter, label.middle, label.text);
}

} // namespace trundle
