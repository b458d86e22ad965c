#include "editor/viewport/tools/push_tool.h"

#include <QPainter>

#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/label.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"

namespace trundle {
namespace {

constexpr double kPushTremble = 4;    // pixels; drag threshold
constexpr double kPerKgAndMetre = 20; // N
constexpr double kMaxPerKg = 60;      // N

} // namespace

PushTool::PushTool(ToolView& view) : m_view(view) {
    connect(&view.context().world, &ViewportScene::posed, this, [this] {
        if (m_pushing) push();
    });
}

bool PushTool::press(const Pointer& pointer) {
    const ViewportScene& world = m_view.context().world;
    if (pointer.button != Qt::LeftButton || !pointer.modifiers.testFlag(Qt::ControlModifier) || !world.isRunning()) return false;
    const std::vector<RayHit> hits = world.hitsAlong(m_view.camera().rayAt(pointer.at));
    if (hits.empty() || hits.front().geom.kind != ObjectKind::Geom) return false;
    m_body = world.objects()->ownerOf(hits.front().geom);
    m_grip = world.poseOf(*m_body).inverse() * hits.front().point;
    m_mass = 0;
    for (const BodySpec& body : world.objects()->robotOf(*m_body)->config->bodies) m_mass += body.mass.mass;
    m_start = m_now = pointer.at;
    m_pushing = false;
    return true;
}

Vec3 PushTool::gripNow() const { return m_view.context().world.poseOf(*m_body) * m_grip; }

void PushTool::drag(const Pointer& pointer) {
    m_now = pointer.at;
    m_pushing |= (m_now - m_start).manhattanLength() > kPushTremble;
    if (m_pushing) push();
}

void PushTool::push() {
    if (!m_body || !m_view.context().world.isRunning()) return cancel();
    const Vec3 grip = gripNow(), forward = m_view.camera().free().forward();
    const ViewRay ray = m_view.camera().rayAt(m_now);
    const double towards = ray.direction.dot(forward);
    if (towards < 1e-6) return;
    const Vec3 request = ray.origin + (grip - ray.origin).dot(forward) / towards * ray.direction;
    m_force = kPerKgAndMetre * m_mass * (request - grip);
    if (m_force.norm() > kMaxPerKg * m_mass) m_force *= kMaxPerKg * m_mass / m_force.norm();
    m_view.context().session.robots().push(m_view.context().world.objects()->pathOf(*m_body, '/'), m_force, grip);
    m_view.widget().update();
}

void PushTool::release(const Pointer& pointer) {
    if (m_pushing) {
        m_view.context().session.robots().endPush();
    } else if (m_body && pointer.button == Qt::LeftButton) {
        m_view.context().selection.toggle(m_view.context().world.objects()->pathOf({ObjectKind::Robot, m_body->instance}));
    }
    m_body.reset();
    m_pushing = false;
    m_view.widget().update();
}

void PushTool::cancel() {
    if (m_pushing) m_view.context().session.robots().endPush();
    m_body.reset();
    m_pushing = false;
}

void PushTool::paint(QPainter& painter) {
    if (!m_pushing || !m_body) return;
    const auto from = m_view.shownPixelOf(gripNow());
    if (!from) return;
    const QColor colour(255, 208, 60);
    painter.setPen(QPen(QColor(10, 12, 16, 120), 5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(*from, m_now);
    painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(*from, m_now);
    painter.setBrush(colour);
    painter.drawEllipse(*from, 3.5, 3.5);
    paintLabel(painter, m_now + QPointF(0, -20), QStringLiteral("%1 N").arg(m_force.norm(), 0, 'g', 3));
}

} // namespace trundle
