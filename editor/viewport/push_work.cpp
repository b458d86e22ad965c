#include "editor/viewport/push_work.h"

#include <QPainter>

#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/plate.h"
#include "editor/viewport/shown_world.h"
#include "editor/viewport/view.h"

namespace trundle {
namespace {

constexpr double kPushTremble = 4;    // pixels before a press becomes a push
constexpr double kPerKgAndMetre = 20; // N
constexpr double kMostPerKg = 60;     // N

} // namespace

PushWork::PushWork(View& view) : m_view(view) {
    connect(&view.parts().world, &ShownWorld::posed, this, [this] {
        if (m_pushing) push();
    });
}

bool PushWork::press(const Pointer& pointer) {
    const ShownWorld& world = m_view.parts().world;
    if (pointer.button != Qt::LeftButton || !pointer.modifiers.testFlag(Qt::ControlModifier) || !world.isRunning()) return false;
    const std::vector<RayHit> hits = world.hitsAlong(m_view.rayAt(pointer.at));
    if (hits.empty() || hits.front().geom.kind != ObjectKind::Geom) return false;
    m_body = world.objects()->ownerOf(hits.front().geom);
    m_grip = world.poseOf(*m_body).inverse() * hits.front().point;
    m_mass = 0;
    for (const BodySpec& body : world.objects()->robotOf(*m_body)->config->bodies) m_mass += body.mass.mass;
    m_start = m_now = pointer.at;
    m_pushing = false;
    return true;
}

Vec3 PushWork::gripNow() const { return m_view.parts().world.poseOf(*m_body) * m_grip; }

void PushWork::drag(const Pointer& pointer) {
    m_now = pointer.at;
    m_pushing |= (m_now - m_start).manhattanLength() > kPushTremble;
    if (m_pushing) push();
}

void PushWork::push() {
    if (!m_body || !m_view.parts().world.isRunning()) return cancel();
    const Vec3 grip = gripNow(), forward = m_view.camera().forward();
    const ViewRay ray = m_view.rayAt(m_now);
    const double towards = ray.direction.dot(forward);
    if (towards < 1e-6) return;
    const Vec3 wish = ray.origin + (grip - ray.origin).dot(forward) / towards * ray.direction;
    m_force = kPerKgAndMetre * m_mass * (wish - grip);
    if (m_force.norm() > kMostPerKg * m_mass) m_force *= kMostPerKg * m_mass / m_force.norm();
    m_view.parts().session.push(m_view.parts().world.objects()->pathOf(*m_body, '/'), m_force, grip);
    m_view.update();
}

void PushWork::release(const Pointer& pointer) {
    if (m_pushing) {
        m_view.parts().session.endPush();
    } else if (m_body && pointer.button == Qt::LeftButton) {
        m_view.parts().selection.toggle(m_view.parts().world.objects()->pathOf({ObjectKind::Robot, m_body->instance}));
    }
    m_body.reset();
    m_pushing = false;
    m_view.update();
}

void PushWork::cancel() {
    if (m_pushing) m_view.parts().session.endPush();
    m_body.reset();
    m_pushing = false;
}

void PushWork::paint(QPainter& painter) {
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
    paintPlate(painter, m_now + QPointF(0, -20), QStringLiteral("%1 N").arg(m_force.norm(), 0, 'g', 3));
}

} // namespace trundle
