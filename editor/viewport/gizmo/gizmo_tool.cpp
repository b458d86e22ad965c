#include "editor/viewport/gizmo/gizmo_tool.h"

#include <cmath>

#include <QElapsedTimer>
#include <QKeyEvent>

#include "editor/document/selection.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"

namespace trundle {
namespace {

constexpr int kLeastPaceMs = 16;
constexpr double kFlushFineness = 1e-5; // m, of what has snapped to a face

/// The power of ten at or below a length (m); number resolution for one pixel.
double decimalBelow(double length) { return std::pow(10.0, std::floor(std::log10(std::clamp(length, 1e-6, 0.1)) + 1e-9)); }

/// The world axis closest to the direction `request`.
Vec3 mainAxis(const Vec3& request, bool upToo) {
    int best = 0;
    for (int k = 1; k < (upToo ? 3 : 2); ++k)
        if (std::abs(request[k]) > std::abs(request[best])) best = k;
    Vec3 axis = Vec3::Zero();
    axis[best] = request[best] < 0 ? -1 : 1;
    return axis;
}

} // namespace

GizmoTool::GizmoTool(ToolView& view) : m_view(view) {
    const ViewContext& context = view.context();
    const auto forget = [this] { m_held.reset(); };
    connect(&context.world, &ViewportScene::replaced, this, forget);
    connect(&context.world, &ViewportScene::posed, this, forget);
    connect(&context.world, &ViewportScene::marked, this, forget);
    connect(&context.selection, &Selection::changed, this, forget);
    connect(&context.settings, &ViewSettings::changed, this, [this] {
        m_hot = {};
        m_held.reset(); // rebuilt, since moving and scaling select differently
    });
    m_pace.setSingleShot(true);
    connect(&m_pace, &QTimer::timeout, this, [this] {
        if (m_pending) apply();
    });
}

TransformSelection::Operation GizmoTool::purpose() const {
    return m_view.context().settings.tool() == Tool::Scale ? TransformSelection::Operation::Scale
                                                           : TransformSelection::Operation::Move;
}

TransformSelection* GizmoTool::held() {
    if (!m_held) m_held = std::make_unique<TransformSelection>(m_view.context(), purpose());
    return m_held->empty() ? nullptr : m_held.get();
}

std::optional<GizmoPose> GizmoTool::place(bool layout) {
    const ViewSettings& settings = m_view.context().settings;
    const Tool tool = settings.tool();
    if (tool != Tool::Move && tool != Tool::Rotate && tool != Tool::Scale) return std::nullopt;
    TransformSelection* held = m_dragged ? m_dragged.get() : this->held();
    if (!held) return std::nullopt;
    GizmoPose place;
    if (layout) {
        const LayoutExtent* extent = tool == Tool::Scale ? held->layoutExtent() : nullptr;
        if (!extent) return std::nullopt;
        place.layout = true;
        place.axes = extent->axes().rotation.toRotationMatrix();
        place.origin = extent->centre();
        place.half = extent->half();
        place.sizes = extent->sizeNames();
        place.margin = held->memberReach();
        addSight(place);
        return place;
    }
    const bool local = settings.axes() == AxesOf::Local || tool == Tool::Scale;
    if (local) place.axes = held->pivot().rotation.toRotationMatrix();
    else if (settings.axes() == AxesOf::Parent) place.axes = held->pivotFrame().rotation.toRotationMatrix();
    place.origin = held->pivot().position;
    if (tool == Tool::Scale) {
        place.origin = held->sizeCentre();
        place.half = held->halfExtent();
        place.sizes = held->sizeNames();
        if (place.half.isZero()) return std::nullopt;
    }
    addSight(place);
    return place;
}

void GizmoTool::addSight(GizmoPose& place) const {
    const ViewCamera& camera = m_view.camera().free();
    place.metresPerPixel = camera.metresPerPixel(m_view.widget().width(), place.origin);
    const Vec3 sight = place.origin - m_view.camera().view().eye;
    place.forward = camera.isParallel() || sight.norm() < 1e-9 ? camera.forward() : sight.normalized();
}

std::optional<Gizmo> GizmoTool::gizmo(bool asShown, bool layout) {
    std::optional<GizmoPose> at = place(layout);
    if (!at || (m_drag && m_drag->handle().layout != layout)) return std::nullopt;
    if (m_drag && m_drag->handle().kind != GizmoHandle::Kind::Ring) at->origin = m_drag->motion() * m_startPlace.origin;
    if (m_drag && m_drag->handle().kind == GizmoHandle::Kind::Size) at->half += m_drag->amount();
    return Gizmo(m_view.context().settings.tool(), *at,
                 [this, asShown](const Vec3& p) { return asShown ? m_view.shownPixelOf(p) : m_view.camera().pixelOf(p); });
}

std::optional<QPointF> GizmoTool::spot(const GizmoHandle& handle) {
    const auto gizmo = this->gizmo(false, handle.layout);
    return gizmo ? gizmo->spot(handle) : std::nullopt;
}

GizmoHandle GizmoTool::hit(const QPointF& at) {
    for (const bool layout : {false, true})
        if (const auto gizmo = this->gizmo(false, layout))
            if (const GizmoHandle handle = gizmo->hit(at)) return handle;
    return {};
}

bool GizmoTool::press(const Pointer& pointer) {
    if (pointer.button != Qt::LeftButton) return false;
    const GizmoHandle handle = hit(pointer.at);
    if (!handle) return false;
    m_mergeKey = "gizmo " + std::to_string(m_view.context().document.revision());
    m_startPlace = *place(handle.layout);
    m_dragged = std::make_unique<TransformSelection>(m_view.context(), purpose());
    m_drag = std::make_unique<GizmoDrag>(handle, m_startPlace, m_view.camera().rayAt(pointer.at), pointer.at);
    if (handle.kind != GizmoHandle::Kind::Ring && handle.kind != GizmoHandle::Kind::Size)
        m_snap = std::make_unique<MoveSnap>(m_view, *m_dragged, m_startPlace.axes);
    const QString title = m_dragged->title();
    m_name = handle.kind == GizmoHandle::Kind::Ring   ? tr("Turn %1").arg(title)
             : handle.kind == GizmoHandle::Kind::Size ? tr("Resize %1").arg(title)
                                                      : tr("Move %1").arg(title);
    m_hot = handle;
    m_pointer = pointer;
    m_view.context().document.edits().endMerge();
    m_view.widget().update();
    return true;
}

void GizmoTool::drag(const Pointer& pointer) {
    if (!m_drag) return;
    m_pointer = pointer;
    const ViewSettings& settings = m_view.context().settings;
    const bool snaps = this->snaps(pointer);
    m_drag->to(m_view.camera().rayAt(pointer.at), pointer.at, snaps ? settings.moveStep() : 0,
               snaps ? settings.rotationStep() : 0, pointer.modifiers.testFlag(Qt::AltModifier));
    if (m_snap) m_snap->clear();
    if (m_snap && snaps && m_drag->typed().empty()) m_snap->apply(*m_drag, m_startPlace.origin);
    m_pending = true;
    if (!m_pace.isActive()) apply();
    showStatus();
}

bool GizmoTool::snaps(const Pointer& pointer) const {
    const bool toggled = pointer.modifiers & (Qt::ControlModifier | Qt::ShiftModifier);
    return m_view.context().settings.snaps() != toggled;
}

DragFineness GizmoTool::fineness() const {
    if (m_snap && m_snap->hasSnapped()) return {kFlushFineness};
    if (!m_drag->typed().empty() || snaps(m_pointer)) return {};
    return {decimalBelow(m_startPlace.metresPerPixel), 0.1};
}

void GizmoTool::apply() {
    m_pending = false;
    if (!m_drag || !m_dragged) return;
    QElapsedTimer cost;
    cost.start();
    const DragFineness fine = fineness();
    const int side = m_drag->isOneSided() ? m_drag->handle().side : 0;
    const Status done = m_drag->handle().kind != GizmoHandle::Kind::Size
                            ? m_dragged->move(m_drag->motion(), m_name, m_mergeKey, fine)
                        : m_drag->handle().layout ? m_dragged->resizeLayout(m_drag->amount(), side, m_name, m_mergeKey, fine)
                                                  : m_dragged->resize(m_drag->amount(), side, m_name, m_mergeKey, fine);
    if (!done) m_view.hints().setHint(QString::fromStdString(done.error().message));
    // In a large experiment an edit takes long; the pause keeps the window responsive.
    m_pace.start(std::max(kLeastPaceMs, int(cost.elapsed())));
    m_view.redraw();
}

void GizmoTool::showStatus() {
    const QString& fault = m_drag->fault();
    m_view.hints().setHovered({}, fault.isEmpty() ? m_drag->readOut() : m_drag->readOut() + QStringLiteral("  ") + fault);
    QString hint =
        tr("Type an exact value, with or without a unit · Enter applies · Esc cancels · Ctrl or Shift toggles snapping");
    const GizmoHandle& handle = m_drag->handle();
    if (handle.kind == GizmoHandle::Kind::Size && m_startPlace.sizes[handle.axis].hasTwoSides())
        hint += tr(" · Alt keeps the centre fixed");
    m_view.hints().setHint(hint);
    m_view.widget().update();
}

void GizmoTool::release(const Pointer& pointer) {
    if (m_drag && !m_drag->fault().isEmpty()) { // not what the mouse has reached instead
        const QString fault = m_drag->fault();
        cancel();
        Q_EMIT m_view.context().document.refused(fault);
        return;
    }
    if (m_pending) apply();
    m_pace.stop();
    m_view.context().document.edits().endMerge();
    m_drag.reset();
    m_snap.reset();
    m_dragged.reset();
    m_held.reset();
    m_view.hints().setHint({});
    m_view.hints().setHovered({}, {});
    (void)hover(pointer); // highlights the handle that the next press would hit
    m_view.widget().update();
}

void GizmoTool::cancel() {
    m_pending = false;
    m_drag.reset();
    if (m_dragged && m_dragged->isRunning()) (void)m_dragged->move(Pose{}, m_name, m_mergeKey);
    m_view.context().document.edits().discardMerge(m_mergeKey);
    release({});
}

bool GizmoTool::hover(const Pointer& pointer) {
    const GizmoHandle hot = hit(pointer.at);
    if (!(hot == m_hot)) {
        m_hot = hot;
        m_view.widget().update();
    }
    if (hot) m_view.hints().setHovered({}, {});
    return bool(hot);
}

void GizmoTool::leave() {
    if (!m_hot || m_drag) return;
    m_hot = {};
    m_view.widget().update();
}

bool GizmoTool::key(QKeyEvent& event) {
    if (!m_drag) return !m_view.isMouseBusy() && nudge(event);
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        if (m_drag->fault().isEmpty()) m_view.endTool();
        return true;
    }
    if (!m_drag->type(event.key(), event.text())) return false;
    if (m_snap) m_snap->clear(); // the number is exact
    apply();
    showStatus();
    return true;
}

bool GizmoTool::nudge(const QKeyEvent& event) {
    const ViewCamera& camera = m_view.camera().free();
    const CameraView view = m_view.camera().view();
    const Vec3 right = cameraAxes(view).col(0), up = cameraAxes(view).col(1);
    // In a view from above, up means away from the camera; in a side view it means up.
    const bool flat = std::abs(camera.forward().z()) < 0.3 && camera.isParallel();
    const Vec3 upward = flat ? Vec3::UnitZ() : mainAxis(camera.forward().z() < 0 ? Vec3(up + camera.forward()) : up, false);
    Vec3 way;
    switch (event.key()) {
    case Qt::Key_Left: way = -mainAxis(right, false); break;
    case Qt::Key_Right: way = mainAxis(right, false); break;
    case Qt::Key_Up: way = upward; break;
    case Qt::Key_Down: way = -upward; break;
    case Qt::Key_PageUp: way = Vec3::UnitZ(); break;
    case Qt::Key_PageDown: way = -Vec3::UnitZ(); break;
    default: return false;
    }
    TransformSelection now(m_view.context());
    if (now.empty()) return false;
    const double step = m_view.context().settings.moveStep() * (event.modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1);
    (void)now.move({step * way, Quat::Identity()}, tr("Nudge %1").arg(now.title()), "nudge " + now.title().toStdString());
    return true;
}

void GizmoTool::paint(QPainter& painter) {
    for (const bool layout : {false, true})
        if (const auto gizmo = this->gizmo(true, layout)) gizmo->paint(painter, m_hot, m_drag != nullptr);
    if (m_snap) m_snap->paint(painter);
}

} // namespace trundle
