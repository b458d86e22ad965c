#include "editor/viewport/tools/navigation.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>

#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"

namespace trundle {
namespace {

constexpr double kRadPerPixel = 0.0065;
constexpr double kZoomPerStep = 0.87; // per notch of the wheel
constexpr double kPixelsPerStep = 20; // for a zoom drag
constexpr double kClick = 3;          // pixels; smaller movements count as a click
constexpr int kFlyMs = 16;
constexpr int kFlyKeys[] = {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};

/// Intersection of a ray with the plane through `at` that faces the camera.
Vec3 onPlane(const ViewRay& ray, const Vec3& at, const Vec3& forward) {
    const double along = ray.direction.dot(forward);
    return ray.origin + (std::abs(along) < 1e-9 ? 0 : (at - ray.origin).dot(forward) / along) * ray.direction;
}

} // namespace

QString Navigation::hint() const {
    const bool orbits = m_mode == CameraDrag::Orbit, pans = m_view.context().settings.navigation() == NavigationStyle::Trundle;
    QString text = orbits ? tr("Drag orbits") + QStringLiteral(" · ") : QString();
    if (pans) text += tr("Shift and drag pans") + QStringLiteral(" · ");
    return text + tr("W A S D, Q and E fly, the wheel sets how fast");
}

Navigation::Navigation(ToolView& view) : m_view(view) { connect(&m_timer, &QTimer::timeout, this, &Navigation::fly); }

bool Navigation::press(const Pointer& pointer) {
    const CameraDrag drag = cameraDrag(m_view.context().settings.navigation(), pointer.button, pointer.modifiers);
    if (drag == CameraDrag::None) return false;
    m_button = pointer.button;
    m_mode = drag;
    m_start = m_last = pointer.at;
    m_about = m_view.camera().pointUnder(pointer.at);
    m_moved = m_flown = false;
    return true;
}

void Navigation::drag(const Pointer& pointer) {
    if (!m_moved && (pointer.at - m_start).manhattanLength() < kClick) return;
    if (!m_moved && m_button == Qt::RightButton) // users rarely discover flying without a hint
        m_view.hints().setHint(hint());
    m_moved = true;
    const QPointF by = pointer.at - m_last;
    m_last = pointer.at;
    m_view.camera().change([&](ViewCamera& camera) {
        if (m_flown) return camera.rotate(-kRadPerPixel * 0.5 * by.x(), -kRadPerPixel * 0.5 * by.y());
        if (m_mode == CameraDrag::Fly) return;
        if (m_mode == CameraDrag::Orbit) return camera.orbit(-kRadPerPixel * by.x(), -kRadPerPixel * by.y(), m_about);
        if (m_mode == CameraDrag::Zoom) return camera.zoom(std::pow(kZoomPerStep, -by.y() / kPixelsPerStep), m_about);
        camera.pan(m_about, onPlane(m_view.camera().rayAt(pointer.at), m_about, camera.forward()));
    });
}

void Navigation::release(const Pointer& pointer) {
    const bool click = !m_moved && !m_flown && m_button == Qt::RightButton && pointer.button == Qt::RightButton;
    m_mode = CameraDrag::None;
    m_view.hints().setHint({});
    stopFlying();
    if (click) m_view.requestMenu(pointer.at);
}

void Navigation::cancel() {
    m_mode = CameraDrag::None;
    m_view.hints().setHint({});
    stopFlying();
}

bool Navigation::key(QKeyEvent& event) {
    if (m_mode == CameraDrag::None || m_button != Qt::RightButton) return false;
    if (std::find(std::begin(kFlyKeys), std::end(kFlyKeys), event.key()) == std::end(kFlyKeys)) return false;
    m_fast = event.modifiers().testFlag(Qt::ShiftModifier);
    m_keys.insert(event.key());
    m_flown = true;
    if (!m_timer.isActive()) {
        m_sinceStep.start();
        m_timer.start(kFlyMs);
    }
    return true;
}

void Navigation::keyReleased(int key) {
    m_keys.erase(key);
    if (m_keys.empty()) m_timer.stop();
}

void Navigation::stopFlying() {
    m_keys.clear();
    m_timer.stop();
}

void Navigation::fly() {
    const double seconds = std::min(0.1, double(m_sinceStep.restart()) / 1000);
    const auto way = [this](int forth, int back) { return double(m_keys.contains(forth)) - double(m_keys.contains(back)); };
    m_view.camera().change([&](ViewCamera& camera) {
        const double pace = m_speed * (m_fast ? 4 : 1) * std::clamp(camera.distance(), 0.5, 30.0) * seconds;
        camera.fly(pace * Vec3(way(Qt::Key_D, Qt::Key_A), way(Qt::Key_E, Qt::Key_Q), way(Qt::Key_W, Qt::Key_S)));
    });
}

void Navigation::wheel(const QPointF& at, double delta) {
    const double steps = delta / 120;
    if (m_flown && m_mode != CameraDrag::None) {
        m_speed = std::clamp(m_speed * std::pow(1.2, steps), 0.05, 20.0);
        return;
    }
    const Vec3 about = m_view.camera().pointUnder(at);
    m_view.camera().change([&](ViewCamera& camera) { camera.zoom(std::pow(kZoomPerStep, steps), about); });
}

} // namespace trundle
