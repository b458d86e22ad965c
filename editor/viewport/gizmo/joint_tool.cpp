#include "editor/viewport/gizmo/joint_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QLineF>
#include <QWidget>

#include "editor/document/selection.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/direction_drag.h"

namespace trundle {
namespace {

constexpr double kPointPixels = 11; // to a point of a body
constexpr double kFineLength = 1e-4, kFineDegrees = 0.1;
constexpr double kFarthestDrag = 1000;                                      // m
constexpr double kLeastSwing = std::numbers::pi / 180, kLeastTravel = 1e-3; // rad, m; 0 would be no stop

double stepped(double value, double step) { return step > 0 ? step * std::round(value / step) : value; }

/// The main axis of the frame that a direction is nearest to.
int mainAxisOf(const Vec3& v) {
    int axis = 0;
    v.cwiseAbs().maxCoeff(&axis);
    return axis;
}

/// Where a ray meets a plane, if it is in front.
std::optional<Vec3> onPlane(const ViewRay& ray, const Vec3& point, const Vec3& normal) {
    const double towards = normal.dot(ray.direction);
    if (std::abs(towards) < 1e-6) return std::nullopt;
    const double distance = normal.dot(point - ray.origin) / towards;
    if (distance < 0 || distance > kFarthestDrag) return std::nullopt;
    return ray.origin + distance * ray.direction;
}

/// How far along a line its nearest point to the ray is.
double alongLine(const ViewRay& ray, const Vec3& point, const Vec3& axis) {
    const Vec3 between = point - ray.origin;
    const double b = axis.dot(ray.direction), n = 1 - b * b;
    return n < 1e-6 ? 0 : (b * ray.direction.dot(between) - axis.dot(between)) / n;
}

} // namespace

JointTool::JointTool(ToolView& view) : m_view(view) {
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

bool JointTool::isOn() const {
    const Tool tool = m_view.context().settings.tool();
    return tool == Tool::Select || tool == Tool::Move || tool == Tool::Rotate || tool == Tool::Scale;
}

const EditedJoint* JointTool::joint() {
    if (!isOn()) return nullptr;
    if (!m_known) m_joint = EditedJoint::selected(m_view.context());
    m_known = true;
    return m_joint ? &*m_joint : nullptr;
}

bool JointTool::snaps(const Pointer& pointer) const {
    return m_view.context().settings.snaps() != bool(pointer.modifiers & (Qt::ControlModifier | Qt::ShiftModifier));
}

std::optional<QPointF> JointTool::spot(const JointHandle& handle) {
    const EditedJoint* joint = this->joint();
    return joint ? JointHandles(*joint, m_view, false).spot(handle) : std::nullopt;
}

bool JointTool::press(const Pointer& pointer) {
    const EditedJoint* joint = this->joint();
    if (!joint || pointer.button != Qt::LeftButton) return false;
    const JointHandles handles(*joint, m_view, false);
    const JointHandle handle = handles.hit(pointer.at);
    if (!handle) return false;
    m_start = *joint;
    m_dragged = m_hot = handle;
    m_length = handles.length();
    m_mergeKey = "joint " + std::to_string(m_view.context().document.revision());
    m_view.context().document.edits().endMerge();
    const bool second = handle.stop.isSecond;
    if (pointer.twice && handle.kind == JointHandle::Kind::Axis) {
        report(m_start->setAxis(m_view.context().document, -m_start->axis(second), second, m_mergeKey));
        m_dragged = {};
        return true;
    }
    begin();
    m_lastAngle = angleAt(m_view.camera().rayAt(pointer.at), m_start->axis(second));
    m_view.hints().setHint(handle.kind == JointHandle::Kind::Axis
                               ? tr("Esc cancels · Ctrl or Shift toggles snapping · a double click reverses the axis")
                               : tr("Esc cancels · Ctrl or Shift toggles snapping"));
    m_view.widget().update();
    return true;
}

/// A stop begins at its value, or where its handle is.
void JointTool::begin() {
    const JointSpec& spec = m_start->spec();
    const double free = m_start->turns() ? std::numbers::pi / 2 : 0;
    m_angle = m_start->stop(m_dragged.stop).value_or(m_dragged.stop.isHigh ? free : -free);
    if (spec.type == JointType::Slider) m_angle = 0;
}

double JointTool::angleAt(const ViewRay& ray, const Vec3& axis) const {
    const Pose& X_WC = m_start->X_WC();
    const auto at = onPlane(ray, X_WC * m_start->spec().anchor, X_WC.rotation * axis);
    if (!at) return m_lastAngle;
    const Vec3 out = X_WC.inverse() * *at - m_start->spec().anchor, zero = m_start->zeroDirection(axis);
    return std::atan2(out.dot(axis.cross(zero)), out.dot(zero));
}

/// In the plane of two axes of the config that faces the camera most, so that the third number stays.
Vec3 JointTool::draggedAnchor(const Pointer& pointer, double& fine) const {
    const Pose& X_WC = m_start->X_WC();
    const Vec3 start = m_start->spec().anchor;
    const bool isSnapping = snaps(pointer);
    if (isSnapping)
        for (const Vec3& point : m_start->points())
            if (const auto at = m_view.camera().pixelOf(X_WC * point); at && QLineF(*at, pointer.at).length() < kPointPixels)
                return point;
    const Vec3 sight = X_WC.rotation.conjugate() * m_view.camera().rayAt(pointer.at).direction;
    const auto at = onPlane(m_view.camera().rayAt(pointer.at), X_WC * start, X_WC.rotation * Vec3(Vec3::Unit(mainAxisOf(sight))));
    if (!at) return start;
    Vec3 by = X_WC.inverse() * *at - start;
    by[mainAxisOf(sight)] = 0;
    const double step = isSnapping ? m_view.context().settings.moveStep() : 0;
    for (int k = 0; k < 3; ++k) by[k] = stepped(by[k], step);
    fine = isSnapping ? 1e-6 : kFineLength;
    return start + by;
}

Vec3 JointTool::draggedAxis(const Pointer& pointer) const {
    const Pose& X_WC = m_start->X_WC();
    auto directions = directionsUnder(m_view.camera().rayAt(pointer.at), X_WC * m_start->spec().anchor,
                                      X_WC.rotation * m_start->axis(m_dragged.stop.isSecond), m_length);
    for (Vec3& direction : directions) direction = X_WC.rotation.conjugate() * direction;
    return snaps(pointer) ? snappedDirection(directions, m_view.context().settings.rotationStep()) : directions[0];
}

double JointTool::draggedStop(const Pointer& pointer, double& fine) {
    const ViewSettings& settings = m_view.context().settings;
    const bool isSnapping = snaps(pointer), second = m_dragged.stop.isSecond;
    const ViewRay ray = m_view.camera().rayAt(pointer.at);
    double value = 0, most = std::numbers::pi;
    if (m_start->turns()) {
        const double angle = angleAt(ray, m_start->axis(second));
        m_angle += std::remainder(angle - m_lastAngle, 2 * std::numbers::pi);
        m_lastAngle = angle;
        const double step = isSnapping ? std::min(5.0, settings.rotationStep()) * std::numbers::pi / 180 : 0;
        value = stepped(m_angle, step);
        fine = isSnapping ? 1e-4 : kFineDegrees;
    } else {
        const Pose& X_WC = m_start->X_WC();
        const double step = isSnapping ? std::min(0.01, settings.moveStep()) : 0;
        value = stepped(alongLine(ray, X_WC * m_start->spec().anchor, X_WC.rotation * m_start->axis(false)), step);
        fine = isSnapping ? 1e-6 : kFineLength;
        most = kFarthestDrag;
    }
    const auto other = m_start->stop({!m_dragged.stop.isHigh, second});
    return m_dragged.stop.isHigh ? std::clamp(value, other.value_or(-most), most)
                                 : std::clamp(value, -most, other.value_or(most));
}

/// Between the axis and what is under the pointer, on the sphere of the handle.
double JointTool::draggedSwing(const Pointer& pointer, double& fine) const {
    const Pose& X_WC = m_start->X_WC();
    const Vec3 axis = X_WC.rotation * m_start->axis(false), zero = X_WC.rotation * m_start->zeroDirection(m_start->axis(false));
    const double before = m_start->spec().swingStop.value_or(std::numbers::pi / 2);
    const Vec3 direction =
        directionsUnder(m_view.camera().rayAt(pointer.at), X_WC * m_start->spec().anchor,
                        std::cos(before) * axis + std::sin(before) * zero, JointHandles::kCirclePart * m_length)[0];
    const bool isSnapping = snaps(pointer);
    const double step = isSnapping ? std::min(5.0, m_view.context().settings.rotationStep()) * std::numbers::pi / 180 : 0;
    fine = isSnapping ? 1e-4 : kFineDegrees;
    return std::clamp(stepped(std::acos(std::clamp(axis.dot(direction), -1.0, 1.0)), step), kLeastSwing, std::numbers::pi);
}

double JointTool::draggedTravel(const Pointer& pointer, double& fine) const {
    const Pose& X_WC = m_start->X_WC();
    const bool isSnapping = snaps(pointer);
    const double step = isSnapping ? std::min(0.005, m_view.context().settings.moveStep()) : 0;
    fine = isSnapping ? 1e-6 : kFineLength;
    const double along =
        alongLine(m_view.camera().rayAt(pointer.at), X_WC * m_start->spec().anchor, X_WC.rotation * m_start->axis(false));
    return std::clamp(stepped(m_dragged.stop.isHigh ? along : -along, step), kLeastTravel, kFarthestDrag);
}

void JointTool::drag(const Pointer& pointer) {
    if (!m_start) return;
    Document& document = m_view.context().document;
    double fine = 1e-6;
    switch (m_dragged.kind) {
    case JointHandle::Kind::Anchor: {
        const Vec3 anchor = draggedAnchor(pointer, fine);
        report(m_start->setAnchor(document, anchor, fine, m_mergeKey));
        break;
    }
    case JointHandle::Kind::Axis:
        report(m_start->setAxis(document, draggedAxis(pointer), m_dragged.stop.isSecond, m_mergeKey));
        break;
    case JointHandle::Kind::Stop: {
        const double value = draggedStop(pointer, fine);
        report(m_start->setStop(document, m_dragged.stop, value, fine, m_mergeKey));
        break;
    }
    case JointHandle::Kind::Swing: {
        const double swing = draggedSwing(pointer, fine);
        report(m_start->setSwing(document, swing, fine, m_mergeKey));
        break;
    }
    case JointHandle::Kind::Travel: {
        const double travel = draggedTravel(pointer, fine);
        report(m_start->setTravel(document, travel, fine, m_mergeKey));
        break;
    }
    case JointHandle::Kind::None: return;
    }
    if (const EditedJoint* now = joint()) m_view.hints().setHovered({}, JointHandles(*now, m_view, false).label(m_dragged));
    m_view.widget().update();
}

void JointTool::report(const Status& done) {
    if (!done) m_view.hints().setHint(QString::fromStdString(done.error().message));
}

void JointTool::release(const Pointer& pointer) {
    m_view.context().document.edits().endMerge();
    m_start.reset();
    m_dragged = {};
    m_view.hints().setHint({});
    m_view.hints().setHovered({}, {});
    (void)hover(pointer);
    m_view.widget().update();
}

void JointTool::cancel() {
    m_view.context().document.edits().discardMerge(m_mergeKey);
    release({});
}

bool JointTool::hover(const Pointer& pointer) {
    const EditedJoint* joint = this->joint();
    const JointHandle hot = joint ? JointHandles(*joint, m_view, false).hit(pointer.at) : JointHandle{};
    if (!(hot == m_hot)) m_view.widget().update();
    m_hot = hot;
    if (hot) m_view.hints().setHovered({}, JointHandles(*joint, m_view, false).label(hot));
    return bool(hot);
}

void JointTool::leave() {
    if (!m_hot || m_start) return;
    m_hot = {};
    m_view.widget().update();
}

void JointTool::paint(QPainter& painter) {
    if (const EditedJoint* joint = this->joint()) JointHandles(*joint, m_view, true).paint(painter, m_hot);
}

} // namespace trundle
