#include "editor/viewport/gizmo/aim_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QPainter>
#include <QWidget>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/aim_shape.h"
#include "editor/viewport/gizmo/direction_drag.h"
#include "editor/viewport/gizmo/text_in_place.h"
#include "lang/number_text.h"
#include "model/dotted_path.h"
#include "model/shortest_turn.h"
#include "project/objects/written_hpr.h"
#include "scene/queries/range_model.h"

namespace trundle {
namespace {

constexpr double kAimPixels = 110, kAimHandle = 7, kRollHandle = 5, kAimReach = 10, kShapeReach = 5;
constexpr double kRollAlong = 0.55, kRollUp = 0.32;   // where the handle of the roll is, as parts of the line
constexpr double kLeastReach = 1e-3, kLongestPart = 0.7; // m; of the way to the camera
constexpr double kAimDegrees = 180 / std::numbers::pi;
constexpr const char* kAimKeys[] = {"Pos", "HPR"};
const QColor kAimInk(120, 200, 255), kAimHot(255, 208, 60);

Vec3 tripleOf(const ComponentSpec& device, const char* key) {
    const ResolvedValue* value = device.find(key);
    return value && value->value.numbers.size() == 3 ? Vec3(value->value.numbers.data()) : Vec3(Vec3::Zero());
}

Vec3 degreesOf(const Quat& rotation) { return hprFromRotation(rotation) * kAimDegrees; }

/// Heading and pitch that point x in a direction, with the roll of before.
Quat pointing(const Vec3& direction, double roll) {
    return rotationFromHpr({std::atan2(direction.y(), direction.x()), -std::asin(std::clamp(direction.z(), -1.0, 1.0)), roll});
}

} // namespace

AimTool::AimTool(ToolView& view) : m_view(view) {
    const ViewContext& context = view.context();
    const auto forget = [this] {
        m_known = false;
        m_view.widget().update();
    };
    connect(&context.world, &ViewportScene::replaced, this, forget);
    connect(&context.world, &ViewportScene::marked, this, forget);
    connect(&context.world, &ViewportScene::posed, this, [this] { m_known = false; }); // the view repaints with its image
    connect(&context.selection, &Selection::changed, this, forget);
}

std::optional<AimTool::Aimed> AimTool::selected() const {
    const ViewContext& context = m_view.context();
    if (context.selection.paths().size() != 1 || context.world.isRunning() || !context.document.isOpen()) return std::nullopt;
    const std::string path = context.selection.current();
    const auto place = placeOf(*context.document.loaded(), path);
    if (!place || !place->part || !place->part->is(Role::Device) || !place->part->kind) return std::nullopt;
    if (!place->part->kind->find("HPR") || !place->part->kind->find("Body") || isLocked(context.world, path)) return std::nullopt;
    std::optional<Aimed> overridden; // a robot that sets the values of a config otherwise
    const auto& robots = context.world.objects()->experiment().robots;
    for (std::uint32_t r = 0; r < robots.size(); ++r) {
        if (!robots[r].config) continue;
        const RobotConfigSpec& config = *robots[r].config;
        const std::string byConfig = "RobotConfig." + config.name + ".", byRobot = robots[r].name + ".";
        const bool isInside = path.starts_with(byRobot);
        if (!isInside && !path.starts_with(byConfig)) continue;
        const std::string& before = isInside ? byRobot : byConfig;
        const std::string name = path.substr(before.size());
        auto device = std::ranges::find(config.devices, name, &ComponentSpec::name);
        if (device == config.devices.end())
            device = std::ranges::find_if(config.devices, [&](const ComponentSpec& d) { return isNameOf(d.name, name); });
        if (device == config.devices.end()) continue;
        const auto body = std::ranges::find(config.bodies, device->text("Body"), &BodySpec::name);
        if (body == config.bodies.end()) return std::nullopt;
        Aimed aimed;
        const auto own = placeOf(*context.document.loaded(), before + device->name);
        const auto inRobot = placeOf(*context.document.loaded(), byRobot + device->name);
        if (!own || !own->part) return std::nullopt;
        aimed.path = isInside ? byRobot + device->name : path; // in the text of a config all members of a Repeat are one
        aimed.shape = byRobot + device->name;
        aimed.X_WB = context.world.poseOf({ObjectKind::Body, r, std::uint32_t(body - config.bodies.begin())});
        aimed.X_BD = {tripleOf(*device, "Pos"), rotationFromHpr(tripleOf(*device, "HPR"))};
        if (const auto range = rangeModelOf(*device); range && range->ground) aimed.sight = -Vec3::UnitZ();
        aimed.mirror.signs = describedFrame(*context.document.loaded(), *own).signs;
        aimed.described = poseAt(*context.document.loaded(), *own).rotation;
        aimed.hpr = writtenHpr(*context.document.loaded(), *own, aimed.described);
        aimed.text = textInPlace(*context.document.loaded(), aimed.path + ".HPR");
        if (isInside || hasTextsOf(*context.document.loaded(), path, aimed.shape, kAimKeys)) return aimed;
        if (overridden || !inRobot) continue;
        const auto described = [&](const ObjectLocation& at) {
            return aimed.mirror.mirrored(poseAt(*context.document.loaded(), at));
        };
        aimed.X_BD = aimed.X_BD * described(*inRobot).inverse() * described(*own);
        overridden = aimed;
    }
    return overridden;
}

const AimTool::Aimed* AimTool::aimed() {
    const Tool tool = m_view.context().settings.tool();
    if (tool != Tool::Select && tool != Tool::Move && tool != Tool::Rotate) return nullptr;
    if (!m_known) m_aimed = selected();
    m_known = true;
    return m_aimed ? &*m_aimed : nullptr;
}

Vec3 AimTool::end(const Aimed& aimed) const {
    const double length = kAimPixels * m_view.camera().free().metresPerPixel(m_view.widget().width(), aimed.position());
    return aimed.position() + length * aimed.direction();
}

std::optional<QPointF> AimTool::spot() {
    const Aimed* aimed = this->aimed();
    return aimed ? m_view.camera().pixelOf(end(*aimed)) : std::nullopt;
}

std::optional<Vec3> AimTool::rollEnd(const Aimed& aimed) const {
    if (aimed.sight.x() < 0.5) return std::nullopt;
    const double length = (end(aimed) - aimed.position()).norm();
    return aimed.position() + kRollAlong * length * aimed.direction() +
           kRollUp * length * (aimed.X_WB.rotation * (aimed.X_BD.rotation * Vec3::UnitZ()));
}

std::optional<QPointF> AimTool::rollSpot() {
    const Aimed* aimed = this->aimed();
    const auto roll = aimed ? rollEnd(*aimed) : std::nullopt;
    return roll ? m_view.camera().pixelOf(*roll) : std::nullopt;
}

AimTool::Grip AimTool::gripAt(const QPointF& at) {
    const Aimed* aimed = this->aimed();
    if (!aimed) return {};
    if (const auto spot = this->spot(); spot && QLineF(*spot, at).length() < kAimReach) return {Grip::Kind::Sight, end(*aimed)};
    if (const auto roll = rollSpot(); roll && QLineF(*roll, at).length() < kAimReach) return {Grip::Kind::Roll, *rollEnd(*aimed)};
    if (const auto point = pointUnder(m_view, aimShapeOf(m_view, aimed->shape), at, kShapeReach))
        if ((*point - aimed->position()).norm() > kLeastReach) return {Grip::Kind::Shape, *point};
    return {};
}

bool AimTool::press(const Pointer& pointer) {
    if (pointer.button != Qt::LeftButton) return false;
    const Grip grip = gripAt(pointer.at);
    if (grip.kind == Grip::Kind::None) return false;
    m_start = *aimed();
    m_grip = grip;
    m_hot = grip.kind;
    m_wrote = false;
    // What is far away turns on a sphere that the camera is outside of.
    const ViewRay ray = m_view.camera().rayAt(pointer.at);
    const Vec3 out = grip.point - m_start->position();
    m_length = std::min(out.norm(), kLongestPart * (ray.origin - m_start->position()).norm());
    m_gripped = grip.kind == Grip::Kind::Sight ? m_start->direction()
                                               : directionsUnder(ray, m_start->position(), out.normalized(), m_length)[0];
    m_mergeKey = "aim " + std::to_string(m_view.context().document.revision());
    m_view.context().document.edits().endMerge();
    m_view.hints().setHint(tr("Esc cancels · Ctrl or Shift toggles snapping"));
    m_view.widget().update();
    return true;
}

/// What was gripped stays under the mouse.
Quat AimTool::aimedRotation(const Pointer& pointer, bool snaps) const {
    const Quat toBody = m_start->X_WB.rotation.conjugate();
    auto directions = directionsUnder(m_view.camera().rayAt(pointer.at), m_start->position(), m_gripped, m_length);
    for (Vec3& each : directions) each = toBody * (shortestTurn(m_gripped, each) * m_start->direction());
    const Vec3 direction = snaps ? snappedDirection(directions, m_view.context().settings.rotationStep()) : directions[0];
    const Quat& before = m_start->X_BD.rotation;
    return m_start->sight.x() > 0.5 ? pointing(direction, hprFromRotation(before).z())
                                    : Quat(shortestTurn(before * m_start->sight, direction) * before);
}

/// By the angle about the line of sight, as the mouse goes around it.
Quat AimTool::rolledRotation(const Pointer& pointer, bool snaps) const {
    const ViewRay ray = m_view.camera().rayAt(pointer.at);
    const Vec3 axis = m_start->direction(), out = m_grip.point - m_start->position();
    const Vec3 centre = m_start->position() + axis.dot(out) * axis, before = m_grip.point - centre;
    const double towards = axis.dot(ray.direction);
    Vec3 now = before;
    if (std::abs(towards) > 0.05) now = ray.origin + axis.dot(centre - ray.origin) / towards * ray.direction - centre;
    else now = directionsUnder(ray, centre, before.normalized(), before.norm())[0]; // seen from its side
    const double turn = std::atan2(axis.dot(before.cross(now)), before.dot(now));
    const double step = snaps ? m_view.context().settings.rotationStep() / kAimDegrees : 0;
    const Vec3 kept = hprFromRotation(m_start->X_BD.rotation);
    const double roll = kept.z() + turn;
    return rotationFromHpr({kept.x(), kept.y(), step > 0 ? step * std::round(roll / step) : roll});
}

void AimTool::drag(const Pointer& pointer) {
    if (!m_start) return;
    const bool snaps = m_view.context().settings.snaps() != bool(pointer.modifiers & (Qt::ControlModifier | Qt::ShiftModifier));
    const Quat turned = m_grip.kind == Grip::Kind::Roll ? rolledRotation(pointer, snaps) : aimedRotation(pointer, snaps);
    const Status done = turnTo(turned, snaps ? 1e-4 : 0.1);
    if (!done) m_view.hints().setHint(QString::fromStdString(done.error().message));
    if (const Aimed* now = aimed()) m_view.hints().setHovered({}, label(*now));
    m_view.widget().update();
}

/// `fine`: degrees. Without a turn nothing is written that was not written before.
Status AimTool::turnTo(const Quat& rotation, double fine) {
    const auto mirrored = [this](const Quat& q) { return m_start->mirror.mirrored({Vec3::Zero(), q}).rotation; };
    const Quat frame = m_start->X_BD.rotation * mirrored(m_start->described).conjugate(); // of what it is in, in the body
    const Vec3 from = m_start->hpr * kAimDegrees,
               to = hprLike(m_start->hpr, mirrored(frame.conjugate() * rotation)) * kAimDegrees;
    const bool isDefault = m_start->text.empty() && (to - from).cwiseAbs().maxCoeff() < 0.5 * fine; // that of its config
    if (isDefault && !m_wrote) return {};
    const std::string text =
        isDefault ? std::string() : withNumbers(m_start->text, {from.data(), 3}, {to.data(), 3}, "deg", fine);
    m_wrote = true;
    const QString name = tr("Aim %1").arg(QString::fromStdString(m_start->path));
    return m_view.context().document.structure().setValues(
        name, {{m_start->path + ".HPR", isDefault ? ParsedValue() : ParsedValue(text)}}, m_mergeKey);
}

QString AimTool::label(const Aimed& aimed) const {
    const Vec3 hpr = degreesOf(aimed.X_BD.rotation);
    const auto shown = [](double degrees) { return QString::fromStdString(steppedNumber(degrees, 0.1)); };
    if (m_hot == Grip::Kind::Roll) return tr("Roll %1°").arg(shown(hpr.z()));
    return tr("Heading %1°, pitch %2°").arg(shown(hpr.x()), shown(hpr.y()));
}

void AimTool::release(const Pointer& pointer) {
    m_view.context().document.edits().endMerge();
    m_start.reset();
    m_view.hints().setHint({});
    m_view.hints().setHovered({}, {});
    (void)hover(pointer);
    m_view.widget().update();
}

void AimTool::cancel() {
    m_view.context().document.edits().discardMerge(m_mergeKey);
    release({});
}

bool AimTool::hover(const Pointer& pointer) {
    const Grip::Kind hot = gripAt(pointer.at).kind;
    if (hot != m_hot) m_view.widget().update();
    m_hot = hot;
    if (hot != Grip::Kind::None) m_view.hints().setHovered({}, label(*aimed()));
    return hot != Grip::Kind::None;
}

void AimTool::leave() {
    if (m_hot == Grip::Kind::None || m_start) return;
    m_hot = Grip::Kind::None;
    m_view.widget().update();
}

void AimTool::paint(QPainter& painter) {
    const Aimed* aimed = this->aimed();
    if (!aimed) return;
    const ScenePainter scene(painter, m_view);
    if (m_hot == Grip::Kind::Shape)
        for (const auto& [from, to] : aimShapeOf(m_view, aimed->shape)) scene.line(from, to, kAimHot, 1.4);
    const bool isSight = m_hot == Grip::Kind::Sight;
    scene.line(aimed->position(), end(*aimed), isSight ? kAimHot : kAimInk, isSight ? 2.6 : 1.8);
    const auto paintHandle = [&](const Vec3& point, bool isHot, double radius) {
        const auto at = m_view.shownPixelOf(point);
        if (!at) return;
        painter.setPen(QPen(QColor(10, 12, 16, 200), 1.2));
        painter.setBrush(isHot ? kAimHot : kAimInk);
        painter.drawEllipse(*at, radius, radius);
        painter.setBrush(QColor(10, 12, 16, 200));
        painter.drawEllipse(*at, 1.6, 1.6);
    };
    if (const auto roll = rollEnd(*aimed)) {
        const bool isRoll = m_hot == Grip::Kind::Roll;
        const double along = (*roll - aimed->position()).dot(aimed->direction());
        scene.line(aimed->position() + along * aimed->direction(), *roll, isRoll ? kAimHot : kAimInk, isRoll ? 2.2 : 1.4);
        paintHandle(*roll, isRoll, kRollHandle);
    }
    paintHandle(end(*aimed), isSight, kAimHandle);
}

} // namespace trundle
