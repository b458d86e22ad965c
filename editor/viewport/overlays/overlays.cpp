#include "editor/viewport/overlays/overlays.h"

#include <cmath>

#include <QPainter>

#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/beams.h"
#include "editor/viewport/overlays/contact_arrows.h"
#include "editor/viewport/overlays/frusta.h"
#include "editor/viewport/overlays/mass_overlay.h"
#include "editor/viewport/overlays/motion_arrows.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/overlays/regions.h"
#include "editor/viewport/overlays/selected_names.h"
#include "editor/viewport/overlays/springs.h"
#include "editor/viewport/overlays/trails.h"
#include "editor/viewport/radio/radio_legend.h"
#include "editor/widgets/theme.h"
#include "lang/number_text.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxNames = 150, kMaxRobots = 300;
const QColor kShade(10, 12, 16, 110), kJoint(214, 92, 214), kContact(255, 196, 40), kForce(255, 120, 40), kLight(245, 246, 248),
    kEnded(255, 150, 140);

void line(QPainter& painter, const QPointF& a, const QPointF& b, const QColor& colour, double width) {
    painter.setPen(QPen(kShade, width + 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(a, b);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(a, b);
}

void arrow(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour, double width) {
    line(painter, from, to, colour, width);
    const QLineF along(from, to);
    if (along.length() < 5) return;
    const QPointF d = (to - from) / along.length(), n(-d.y(), d.x());
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{to + 2 * d, to - 6 * d + 3.5 * n, to - 6 * d - 3.5 * n});
}

/// Text with a dark outline.
void shaded(QPainter& painter, const QPointF& at, const QString& text, const QColor& colour = kLight) {
    painter.setPen(QColor(10, 12, 16, 170));
    for (const QPointF& by : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) painter.drawText(at + by, text);
    painter.setPen(colour);
    painter.drawText(at, text);
}

/// Names of all objects, or only those of robots that have ended by a fault, which are always named.
void paintNames(QPainter& painter, const ToolView& view, bool all) {
    const ViewportScene& world = view.context().world;
    const EndedRobots& ended = view.context().session.robots().ended();
    if (!all && ended.empty()) return;
    std::vector<QRectF> taken;
    for (const ObjectRef& object : world.objects()->instances()) {
        if (taken.size() >= kMaxNames) break;
        const std::string path = world.objects()->pathOf(object);
        const bool hasEnded = ended.hasEnded(path);
        if (!all && !hasEnded) continue;
        const Bounds bounds = world.objects()->boundsOf(object, view.shownPoses());
        if (bounds.empty() || world.isHidden(object)) continue;
        const auto at = view.shownPixelOf({bounds.centre().x(), bounds.centre().y(), bounds.high.z()});
        if (!at || !view.widget().rect().contains(at->toPoint())) continue;
        QString name = QString::fromStdString(path);
        if (hasEnded) name = QObject::tr("%1 has ended").arg(name);
        const QSizeF size(painter.fontMetrics().horizontalAdvance(name), painter.fontMetrics().height());
        const QRectF box(at->x() - 0.5 * size.width(), at->y() - size.height() - 4, size.width(), size.height());
        // Labels that would overlap an earlier one are skipped.
        if (std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(box); })) continue;
        taken.push_back(box);
        shaded(painter, {box.left(), box.bottom() - painter.fontMetrics().descent()}, name, hasEnded ? kEnded : kLight);
    }
}

/// A joint, from the frame that its points are in to the world.
void paintJoint(QPainter& painter, const ToolView& view, const JointSpec& joint, const Pose& toWorld, bool selected) {
    const QColor colour = selected ? ToolView::outlineColour() : kJoint;
    const Vec3 at = toWorld * joint.anchor;
    const double reach = 26 * view.camera().free().metresPerPixel(view.widget().width(), at);
    const auto from = view.shownPixelOf(at - reach * (toWorld.rotation * joint.axis)),
               to = view.shownPixelOf(at + reach * (toWorld.rotation * joint.axis)), middle = view.shownPixelOf(at);
    if (!from || !to || !middle) return;
    if (joint.type != JointType::Ball && joint.type != JointType::Fixed) arrow(painter, *from, *to, colour, selected ? 2.4 : 1.6);
    painter.setPen(QPen(kShade, 1));
    painter.setBrush(colour);
    painter.drawEllipse(*middle, 3, 3);
}

/// Whether the selected joint is drawn with handles.
bool hasHandles(const ToolView& view) {
    const Tool tool = view.context().settings.tool();
    const bool edits = tool == Tool::Select || tool == Tool::Move || tool == Tool::Rotate || tool == Tool::Scale;
    return edits && !view.context().world.isRunning() && view.context().selection.paths().size() == 1;
}

/// Those between robots move with their child.
void paintLinks(QPainter& painter, const ToolView& view, bool all) {
    const ViewportScene& world = view.context().world;
    const ExperimentSpec& experiment = world.objects()->experiment();
    for (const auto& link : experiment.joints) {
        const bool selected = isSelected(view.context(), link.spec.name);
        const auto robot = std::uint32_t(link.childRobot), body = std::uint32_t(link.spec.child);
        const bool hasOwnHandles = view.context().selection.contains(link.spec.name) && hasHandles(view);
        if ((!all && !selected) || hasOwnHandles || !experiment.robots[robot].config ||
            world.isHidden({ObjectKind::Robot, robot}))
            continue;
        const Pose start = experiment.robots[robot].pose * experiment.robots[robot].config->bodies[body].pose;
        const Pose now = world.objects()->poseOf({ObjectKind::Body, robot, body}, view.shownPoses());
        paintJoint(painter, view, link.spec, now * start.inverse(), selected);
    }
}

void paintJoints(QPainter& painter, const ToolView& view, bool all) {
    const ViewportScene& world = view.context().world;
    const Selection& selection = view.context().selection;
    if (!all && selection.empty()) return;
    paintLinks(painter, view, all);
    const auto& robots = world.objects()->experiment().robots;
    for (std::uint32_t r = 0; r < robots.size() && r < kMaxRobots; ++r) {
        if (!robots[r].config || world.isHidden({ObjectKind::Robot, r})) continue;
        const RobotConfigSpec& config = *robots[r].config;
        for (const JointSpec& joint : config.joints) {
            if (joint.child < 0 || std::size_t(joint.child) >= config.bodies.size()) continue;
            // Selected joints are always shown, including those selected in their config.
            const std::string name = robots[r].name + "." + joint.name;
            const bool isChosen = selection.contains(name) || selection.contains("RobotConfig." + config.name + "." + joint.name);
            const bool selected = isChosen || isSelected(view.context(), name, isNameOfAny(robots[r], config.joints));
            if ((!all && !selected) || (isChosen && hasHandles(view))) continue;
            const auto child = std::uint32_t(joint.child);
            const Pose toWorld =
                world.objects()->poseOf({ObjectKind::Body, r, child}, view.shownPoses()) * config.bodies[child].pose.inverse();
            paintJoint(painter, view, joint, toWorld, selected);
        }
    }
}

/// Scale of the force arrows, and the number of contacts that are not drawn.
void paintContactScale(QPainter& painter, const ToolView& view, double unit, std::size_t count) {
    const QPointF from(76, view.widget().height() - 52), to = from + QPointF(kForcePixels, 0);
    arrow(painter, from, to, kForce, 1.6);
    QString text = QObject::tr("%1 N").arg(QString::fromStdString(steppedNumber(unit, 0.001)));
    if (count > kMaxContacts) text += QObject::tr("  ·  the %1 strongest of %2 contacts").arg(kMaxContacts).arg(count);
    shaded(painter, to + QPointF(10, 4), text);
}

void paintContacts(QPainter& painter, const ToolView& view) {
    const auto snapshot = view.context().session.results().snapshot;
    if (!snapshot || !snapshot->contacts) return;
    const double unit = forceUnit(view.context().world.objects()->experiment());
    for (const ContactArrow& shown : contactArrows(*snapshot->contacts, unit)) {
        const LiveContact& contact = *shown.contact;
        const auto at = view.shownPixelOf(contact.position);
        if (!at) continue;
        const double m = shown.pixels * view.camera().free().metresPerPixel(view.widget().width(), contact.position);
        if (const auto to = view.shownPixelOf(contact.position + m * contact.normal); to && shown.pixels > 2)
            arrow(painter, *at, *to, kForce, shown.isCut ? 3.2 : 1.6);
        painter.setPen(QPen(kShade, 1));
        painter.setBrush(kContact);
        painter.drawEllipse(*at, 2.5, 2.5);
    }
    paintContactScale(painter, view, unit, snapshot->contacts->size());
}

void paintTrails(QPainter& painter, const ToolView& view) {
    if (!view.context().trails) return;
    int hue = 0;
    for (const auto& [robot, trail] : view.context().trails->all()) {
        QPolygonF points;
        for (const Vec3& place : trail)
            if (const auto at = view.shownPixelOf(place + Vec3(0, 0, 0.003))) points << *at;
        painter.setPen(
            QPen(QColor::fromHsv((hue++ * 67 + 205) % 360, 190, 235), 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(points);
    }
}

QString lengthText(double m) {
    if (m < 0.01) return QStringLiteral("%1 mm").arg(QString::fromStdString(steppedNumber(m * 1000, 0.001)));
    if (m < 1) return QStringLiteral("%1 cm").arg(QString::fromStdString(steppedNumber(m * 100, 0.001)));
    if (m >= 1000) return QStringLiteral("%1 km").arg(QString::fromStdString(steppedNumber(m / 1000, 0.001)));
    return QStringLiteral("%1 m").arg(QString::fromStdString(steppedNumber(m, 0.001)));
}

/// Side views see the floor edge-on, so they get a grid of their own: lines at round distances, and a thicker one for the ground.
void paintSideGrid(QPainter& painter, const ToolView& view) {
    const ViewCamera& camera = view.camera().free();
    if (!camera.isParallel() || std::abs(camera.forward().z()) > 0.02) return;
    const double metresPerPixel = camera.metresPerPixel(view.widget().width(), camera.middle()),
                 step = roundNumber(130 * metresPerPixel);
    const Mat3 axes = cameraAxes(view.camera().view());
    const Vec3 right = axes.col(0), middle = camera.middle();
    const double half = 0.5 * view.widget().width() * metresPerPixel, high = 0.5 * view.widget().height() * metresPerPixel;
    const double along = right.dot(middle);
    painter.setPen(QPen(QColor(30, 40, 55, 34), 1));
    for (double x = step * std::ceil((along - half) / step); x <= along + half; x += step) {
        const double at = 0.5 * view.widget().width() + (x - along) / metresPerPixel;
        painter.drawLine(QPointF(at, 0), QPointF(at, view.widget().height()));
    }
    for (double z = step * std::ceil((middle.z() - high) / step); z <= middle.z() + high; z += step) {
        const double at = 0.5 * view.widget().height() - (z - middle.z()) / metresPerPixel;
        painter.drawLine(QPointF(0, at), QPointF(view.widget().width(), at));
    }
    const double ground = 0.5 * view.widget().height() + middle.z() / metresPerPixel;
    painter.setPen(QPen(QColor(30, 40, 55, 130), 1.4));
    painter.drawLine(QPointF(0, ground), QPointF(view.widget().width(), ground));
}

/// Scale bar for the distance at the centre of the view.
void paintScale(QPainter& painter, const ToolView& view) {
    const double metresPerPixel = view.camera().free().metresPerPixel(view.widget().width(), view.camera().free().middle());
    const double x = 76, y = view.widget().height() - 20, room = std::clamp(view.widget().width() - x - 30, 30.0, 130.0);
    const double length = roundNumber(room * metresPerPixel), pixels = length / metresPerPixel;
    const QPolygonF bar{{x, y - 5}, {x, y}, {x + pixels, y}, {x + pixels, y - 5}};
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(10, 12, 16, 150), 4, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawPolyline(bar);
    painter.setPen(QPen(kLight, 1.6, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawPolyline(bar);
    const QString text = lengthText(length);
    shaded(painter, {x + 0.5 * (pixels - painter.fontMetrics().horizontalAdvance(text)), y - 8}, text);
}

void paintAxes(QPainter& painter, const ToolView& view) {
    const QPointF middle(36, view.widget().height() - 36);
    const Mat3 axes = cameraAxes(view.camera().view());
    std::array<int, 3> order{0, 1, 2};
    // Axes that point away are drawn first.
    std::sort(order.begin(), order.end(), [&](int a, int b) { return axes(a, 2) < axes(b, 2); });
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.save();
    painter.setFont(font);
    for (const int k : order) {
        const QPointF tip = middle + 22 * QPointF(axes(k, 0), -axes(k, 1));
        const QColor colour = ink(k == 0 ? Ink::AxisX : k == 1 ? Ink::AxisY : Ink::AxisZ);
        line(painter, middle, tip, colour, 2);
        const QString name = QString(QLatin1Char("XYZ"[k]));
        const QPointF at = middle + 31 * QPointF(axes(k, 0), -axes(k, 1));
        shaded(painter,
               at + QPointF(-0.5 * painter.fontMetrics().horizontalAdvance(name), 0.5 * painter.fontMetrics().capHeight()), name);
    }
    painter.restore();
}

} // namespace

void paintOverlays(QPainter& painter, const ToolView& view) {
    const ViewSettings& settings = view.context().settings;
    if (settings.shows(kOverlayGrid)) paintSideGrid(painter, view);
    if (settings.shows(kOverlayTrails)) paintTrails(painter, view);
    if (settings.shows(kOverlayLinks)) paintRadioLinks(painter, view);
    paintFrusta(painter, view, settings.shows(kOverlayFrusta));
    paintBeams(painter, view, settings.shows(kOverlayBeams));
    paintMotionArrows(painter, view);
    paintRegions(painter, view);
    paintSprings(painter, view);
    paintJoints(painter, view, settings.shows(kOverlayJoints));
    if (settings.shows(kOverlaySupport)) paintSupport(painter, view);
    if (settings.shows(kOverlayInertia)) paintInertia(painter, view);
    if (settings.shows(kOverlayMass)) paintCentresOfMass(painter, view);
    if (settings.shows(kOverlayContacts)) paintContacts(painter, view);
    paintNames(painter, view, settings.shows(kOverlayNames));
    if (settings.shows(kOverlayGrid)) paintScale(painter, view);
    paintAxes(painter, view);
    paintRadioLegend(painter, view);
    paintPinnedValues(painter, view);
}

} // namespace trundle
