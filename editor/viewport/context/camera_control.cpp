#include "editor/viewport/context/camera_control.h"

#include <algorithm>
#include <cmath>

#include <QWidget>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/viewport/context/viewport_scene.h"
#include "scene/queries/framing.h"

namespace trundle {
namespace {

constexpr int kFrameMs = 16;
constexpr int kGlideMs = 160;

} // namespace

CameraControl::CameraControl(const ViewContext& context, const QWidget& view, ViewKind kind) : m_context(context), m_view(view) {
    m_camera.setKind(kind);
    connect(&m_glide, &QTimer::timeout, this, &CameraControl::glide);
    connectContext();
}

void CameraControl::connectContext() {
    connect(&m_context.world, &ViewportScene::replaced, this, &CameraControl::follow);
    connect(&m_context.world, &ViewportScene::posed, this, &CameraControl::follow);
    connect(&m_context.document, &Document::changed, this,
            [this] { // the scene of a run stays, but its Views are those of the text
                if (m_named.empty()) return;
                followNamed();
                Q_EMIT changed();
            });
    connect(&m_context.selection, &Selection::changed, this, [this] {
        if (m_camera.kind() == ViewKind::Follow || m_camera.kind() == ViewKind::Chase) m_camera.setKind(m_camera.kind());
        follow();
    });
}

std::uint32_t CameraControl::width() const { return std::uint32_t(std::max(1, m_view.width())); }
std::uint32_t CameraControl::height() const { return std::uint32_t(std::max(1, m_view.height())); }

void CameraControl::setKind(ViewKind kind) {
    m_glide.stop();
    leaveCamera();
    m_camera.setKind(kind);
    follow();
    Q_EMIT kindChanged();
    Q_EMIT changed();
}

void CameraControl::setView(const CameraView& view) {
    change([&](ViewCamera& camera) { camera.setView(view); });
}

void CameraControl::change(const std::function<void(ViewCamera&)>& change) {
    const ViewKind before = m_camera.kind();
    m_glide.stop();
    const bool left = leaveCamera();
    change(m_camera);
    if (left || m_camera.kind() != before) Q_EMIT kindChanged();
    Q_EMIT changed();
}

void CameraControl::frame(const Bounds& bounds, bool gently) {
    ViewCamera there = m_camera;
    there.frame(bounds, m_view.width(), m_view.height());
    if (!gently) return change([&](ViewCamera& camera) { camera = there; });
    if (leaveCamera()) Q_EMIT kindChanged();
    m_glideFrom = m_camera;
    m_glideTo = there;
    m_gliding.start();
    m_glide.start(kFrameMs);
}

void CameraControl::glide() {
    // Both ends have the same viewing direction, so only position and zoom are interpolated.
    const double share = std::min(1.0, double(m_gliding.elapsed()) / kGlideMs), smooth = share * share * (3 - 2 * share);
    if (share >= 1) m_glide.stop();
    ViewCamera between = m_glideTo;
    const double distance = m_glideFrom.distance() * std::pow(m_glideTo.distance() / m_glideFrom.distance(), smooth);
    const Vec3 middle = (1 - smooth) * m_glideFrom.middle() + smooth * m_glideTo.middle();
    between.pan(middle, m_glideTo.middle());
    between.zoom(distance / m_glideTo.distance(), middle);
    m_camera = share >= 1 ? m_glideTo : between;
    Q_EMIT changed();
}

ViewRay CameraControl::rayAt(const QPointF& at) const { return rayThrough(view(), width(), height(), at.x(), at.y()); }

std::optional<QPointF> CameraControl::pixelOf(const Vec3& point) const {
    const auto at = project(view(), width(), height(), point);
    return at ? std::optional(QPointF(at->x, at->y)) : std::nullopt;
}

Vec3 CameraControl::pointUnder(const QPointF& at) const {
    const ViewRay ray = rayAt(at);
    const std::vector<RayHit> hits = m_context.world.hitsAlong(ray, true);
    if (!hits.empty()) return hits.front().point;
    const double down = -ray.origin.z() / ray.direction.z();
    if (std::isfinite(down) && down > 0 && down < 50 * m_camera.distance()) return ray.origin + down * ray.direction;
    return ray.origin + (m_camera.middle() - ray.origin).dot(ray.direction) * ray.direction;
}

} // namespace trundle
