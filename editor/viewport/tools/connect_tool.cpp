#include "editor/viewport/tools/connect_tool.h"

#include <algorithm>
#include <utility>

#include <QKeyEvent>
#include <QPainter>
#include <QWidget>

#include "editor/document/document.h"
#include "editor/document/structure_edits.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/tools/joint_text.h"
#include "project/edits/plans.h"

namespace trundle {
namespace {

constexpr double kAnchorStep = 5e-3, kFineAnchorStep = 1e-3; // m
const QColor kConnectInk(255, 208, 60), kConnectShade(10, 12, 16, 140);

} // namespace

ConnectTool::ConnectTool(ToolView& view) : m_view(view) {
    connect(&view.context().settings, &ViewSettings::changed, this, &ConnectTool::showHint);
}

bool ConnectTool::isOn() const { return m_view.context().settings.tool() == Tool::Connect; }

void ConnectTool::showHint() {
    if (!isOn()) {
        if (std::exchange(m_hintShown, false)) m_view.hints().setHint({}); // clears only this tool's own hint
        return;
    }
    m_hintShown = true;
    m_view.hints().setHint(tr("%1: drag from the parent to the child · from the floor, the parent is the world · Esc leaves")
                               .arg(QString::fromStdString(m_view.context().settings.jointKind())));
}

std::optional<ConnectTool::Picked> ConnectTool::pickAt(const QPointF& at) const {
    const ViewportScene& world = m_view.context().world;
    const std::vector<RayHit> hits = world.hitsAlong(m_view.camera().rayAt(at), true);
    if (hits.empty()) return std::nullopt;
    const RayHit& hit = hits.front();
    if (world.objects()->robotOf(hit.geom)) return Picked{world.objects()->ownerOf(hit.geom), hit.point, hit.normal};
    return Picked{std::nullopt, hit.point, hit.normal};
}

QString ConnectTool::nameOf(const Picked& picked) const {
    if (!picked.body) return tr("world");
    const RobotSpec& robot = *m_view.context().world.objects()->robotOf(*picked.body);
    return QString::fromStdString(robot.config->bodies[picked.body->body].name);
}

QString ConnectTool::refusal(const Picked& from, const Picked& to) const {
    if (!to.body) return tr("A joint ends at a body.");
    if (from.body == to.body) return tr("A joint connects two bodies.");
    const RobotSpec& robot = *m_view.context().world.objects()->robotOf(*to.body);
    if (robot.scenery || (from.body && m_view.context().world.objects()->robotOf(*from.body)->scenery))
        return tr("Joints of scenery are written in its StaticConfig.");
    if (from.body && from.body->instance != to.body->instance) return {};
    const int parent = from.body ? int(from.body->body) : kWorldBody, child = int(to.body->body);
    const auto joins = [&](const JointSpec& j) {
        return (j.parent == parent && j.child == child) || (j.parent == child && j.child == parent);
    };
    const auto joint = std::ranges::find_if(robot.config->joints, joins);
    return joint == robot.config->joints.end()
               ? QString()
               : tr("%1 and %2 are joined by %3 already.").arg(nameOf(from), nameOf(to), QString::fromStdString(joint->name));
}

bool ConnectTool::press(const Pointer& pointer) {
    if (!isOn() || pointer.button != Qt::LeftButton) return false;
    m_from = pickAt(pointer.at);
    m_to.reset();
    m_now = pointer.at;
    if (!m_view.context().document.isOpen() || m_view.context().world.isRunning()) {
        Q_EMIT m_view.context().document.refused(tr("Reset the run to connect bodies."));
        m_from.reset();
    }
    return true;
}

void ConnectTool::drag(const Pointer& pointer) {
    if (!m_from) return;
    m_now = pointer.at;
    m_to = pickAt(pointer.at);
    const std::string over = m_to && m_to->body ? m_view.context().world.objects()->pathOf(*m_to->body) : std::string();
    const QString kind = QString::fromStdString(m_view.context().settings.jointKind());
    const bool isSame = m_to && m_to->body == m_from->body; // the drag has just begun
    const QString why = m_to && !isSame ? refusal(*m_from, *m_to) : QString();
    const QString joined = m_to && !isSame ? tr("%1: %2 → %3").arg(kind, nameOf(*m_from), nameOf(*m_to)) : QString();
    m_view.hints().setHovered(over, why.isEmpty() ? joined : why);
    m_view.widget().update();
}

void ConnectTool::release(const Pointer&) {
    const auto from = std::exchange(m_from, std::nullopt), to = std::exchange(m_to, std::nullopt);
    m_view.hints().setHovered({}, {});
    m_view.widget().update();
    if (!from || !to || (from->body == to->body && from->body)) return; // a click, or a drag that was given up
    if (const QString why = refusal(*from, *to); !why.isEmpty()) return void(Q_EMIT m_view.context().document.refused(why));
    connectBodies(*from, *to);
}

void ConnectTool::connectBodies(const Picked& from, const Picked& to) {
    const ViewContext& context = m_view.context();
    const ObjectIndex& objects = *context.world.objects();
    const RobotSpec& robot = *objects.robotOf(*to.body);
    const BodySpec& child = robot.config->bodies[to.body->body];
    const bool isInside = !from.body || from.body->instance == to.body->instance; // in one robot
    // From where the body is shown to where it is at the start, in the frame of the text.
    const Pose X_CB = isInside ? child.pose : robot.pose * child.pose, toText = X_CB * context.world.poseOf(*to.body).inverse();
    JointPick pick{nameOf(from).toStdString(), child.name, &child, X_CB, toText * to.point, toText.rotation * to.normal};
    if (!isInside) {
        pick.parent = objects.robotOf(*from.body)->name + "." + pick.parent;
        pick.child = robot.name + "." + pick.child;
    }
    const std::string kind = context.settings.jointKind();
    const std::string text = jointText(kind, pick, context.settings.snaps() ? kAnchorStep : kFineAnchorStep);
    const std::string place = isInside ? robot.name : std::string();
    const QString name = tr("Connect %1 and %2").arg(QString::fromStdString(pick.parent), QString::fromStdString(pick.child));
    const auto plan = [place, text](const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) {
        return planInsert(loaded, place.empty() ? place : renamed(place), text);
    };
    if (context.document.structure().apply(name, {place}, plan)) context.settings.setTool(Tool::Select);
}

void ConnectTool::cancel() {
    m_from.reset();
    m_to.reset();
    m_view.hints().setHovered({}, {});
    m_view.widget().update();
}

bool ConnectTool::hover(const Pointer& pointer) {
    if (!isOn()) return false;
    const auto picked = pickAt(pointer.at);
    const std::string over = picked && picked->body ? m_view.context().world.objects()->pathOf(*picked->body) : std::string();
    m_view.hints().setHovered(over, picked ? nameOf(*picked) : QString());
    return true;
}

bool ConnectTool::needsKey(const QKeyEvent& event) const { return isOn() && event.key() == Qt::Key_Escape; }

bool ConnectTool::key(QKeyEvent& event) {
    if (!needsKey(event)) return false;
    m_view.context().settings.setTool(Tool::Select);
    return true;
}

void ConnectTool::paint(QPainter& painter) {
    if (!m_from) return;
    const auto from = m_view.shownPixelOf(m_from->point);
    if (!from) return;
    const QColor colour = m_to && refusal(*m_from, *m_to).isEmpty() ? kConnectInk : QColor(200, 204, 210);
    for (const auto& [ink, width] : {std::pair(kConnectShade, 4.5), {colour, 2.5}}) {
        painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(*from, m_now);
    }
    painter.setPen(QPen(kConnectShade, 1.2));
    painter.setBrush(colour);
    painter.drawEllipse(*from, 5, 5);
    painter.drawEllipse(m_now, 5, 5);
}

} // namespace trundle
