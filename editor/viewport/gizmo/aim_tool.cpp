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
#include "editor/viewport/gizmo/direction_drag.h"
#include "editor/viewport/gizmo/text_in_place.h"
#include "lang/number_text.h"
#include "model/dotted_path.h"
#include "scene/queries/range_model.h"

namespace trundle {
namespace {

constexpr double kAimPixels = 110, kAimHandle = 7, kAimReach = 10;
constexpr double kAimDegrees = 180 / std::numbers::pi;
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
    connect(&context.world, &ViewportScene::posed, this, [this] { m_known = false; }); // the view repaints with its image
    connect(&context.selection, &Selection::changed, this, forget);
}

std::optional<AimTool::Aimed> AimTool::selected() const {
    const ViewContext& context = m_view.context();
    if (context.selection.paths().size() != 1 || context.world.isRunning() || !context.document.isOpen()) return std::nullopt;
    const std::string path = context.selection.current();
    const auto place = placeOf(*context.document.loaded(), path);
    if (!place || !place->part || !place->part->is(Role::Device) || !place->part->kind) return std::nullopt;
    if (!place->part->kind->find("HPR") || !place->part->kind->find("Body")) return std::nullopt;
    const auto& robots = context.world.objects()->experiment().robots;
    for (std::uint32_t r = 0; r < robots.size(); ++r) {
        if (!robots[r].config) continue;
        const RobotConfigSpec& config = *robots[r].config;
        const std::string byConfig = "RobotConfig." + config.name + ".";
        const auto isIt = [&](const ComponentSpec& d) {
            return robots[r].name + "." + d.name == path || byConfig + d.name == path;
        };
        const auto device = std::ranges::find_if(config.devices, isIt);
        if (device == config.devices.end()) continue;
        const auto body = std::ranges::find(config.bodies, device->text("Body"), &BodySpec::name);
        if (body == config.bodies.end()) return std::nullopt;
        Aimed aimed;
        aimed.path = path;
        aimed.X_WB = context.world.poseOf({ObjectKind::Body, r, std::uint32_t(body - config.bodies.begin())});
        aimed.X_BD = {tripleOf(*device, "Pos"), rotationFromHpr(tripleOf(*device, "HPR"))};
        if (const auto range = rangeModelOf(*device); range && range->ground) aimed.sight = -Vec3::UnitZ();
        aimed.mirror.signs = describedFrame(*context.document.loaded(), *place).signs;
        aimed.text = textInPlace(*context.document.loaded(), path + ".HPR");
        return aimed;
    }
    return std::nullopt;
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

bool AimTool::isOver(const QPointF& at) {
    const auto spot = this->spot();
    return spot && QLineF(*spot, at).length() < kAimReach;
}

bool AimTool::press(const Pointer& pointer) {
    if (pointer.button != Qt::LeftButton || !isOver(pointer.at)) return false;
    m_start = *aimed();
    m_isHot = true;
    m_wrote = false;
    m_length = (end(*m_start) - m_start->position()).norm();
    m_mergeKey = "aim " + std::to_string(m_view.context().document.revision());
    m_view.context().document.edits().endMerge();
    m_view.hints().setHint(tr("Esc cancels · Ctrl or Shift toggles snapping"));
    m_view.widget().update();
    return true;
}

void AimTool::drag(const Pointer& pointer) {
    if (!m_start) return;
    const ViewSettings& settings = m_view.context().settings;
    const bool snaps = settings.snaps() != bool(pointer.modifiers & (Qt::ControlModifier | Qt::ShiftModifier));
    auto directions = directionsUnder(m_view.camera().rayAt(pointer.at), m_start->position(), m_start->direction(), m_length);
    for (Vec3& each : directions) each = m_start->X_WB.rotation.conjugate() * each; // in the body
    const Vec3 direction = snaps ? snappedDirection(directions, settings.rotationStep()) : directions[0];
    const Quat& before = m_start->X_BD.rotation;
    const bool looksAlongX = m_start->sight.x() > 0.5;
    const Quat turned = looksAlongX ? pointing(direction, hprFromRotation(before).z())
                                    : Quat(Quat::FromTwoVectors(before * m_start->sight, direction) * before);
    const Status done = turnTo(turned, snaps ? 1e-4 : 0.1);
    if (!done) m_view.hints().setHint(QString::fromStdString(done.error().message));
    if (const Aimed* now = aimed()) m_view.hints().setHovered({}, label(*now));
    m_view.widget().update();
}

/// `fine`: degrees. Without a turn nothing is written that was not written before.
Status AimTool::turnTo(const Quat& rotation, double fine) {
    const Vec3 from = degreesOf(m_start->mirror.mirrored({Vec3::Zero(), m_start->X_BD.rotation}).rotation),
               to = degreesOf(m_start->mirror.mirrored({Vec3::Zero(), rotation}).rotation);
    const bool isDefault = m_start->text.empty() && to.cwiseAbs().maxCoeff() < 0.5 * fine;
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
    const bool isHot = isOver(pointer.at);
    if (isHot != m_isHot) m_view.widget().update();
    m_isHot = isHot;
    if (isHot) m_view.hints().setHovered({}, label(*aimed()));
    return isHot;
}

void AimTool::leave() {
    if (!m_isHot || m_start) return;
    m_isHot = false;
    m_view.widget().update();
}

void AimTool::paint(QPainter& painter) {
    const Aimed* aimed = this->aimed();
    if (!aimed) return;
    const QColor colour = m_isHot ? kAimHot : kAimInk;
    const ScenePainter scene(painter, m_view);
    scene.line(aimed->position(), end(*aimed), colour, m_isHot ? 2.6 : 1.8);
    const auto at = m_view.shownPixelOf(end(*aimed));
    if (!at) return;
    painter.setPen(QPen(QColor(10, 12, 16, 200), 1.2));
    painter.setBrush(colour);
    painter.drawEllipse(*at, kAimHandle, kAimHandle);
    painter.setBrush(QColor(10, 12, 16, 200));
    painter.drawEllipse(*at, 1.6, 1.6);
}

} // namespace trundle
