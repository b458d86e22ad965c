#include "editor/viewport/frusta.h"

#include <set>

#include <QPainter>

#include "editor/document/selection.h"
#include "editor/viewport/shown_world.h"
#include "editor/viewport/view.h"
#include "scene/camera_model.h"

namespace trundle {
namespace {

constexpr std::size_t kMostFrusta = 200, kMostUnasked = 4;
const QColor kFrustum(70, 196, 222), kFrustumShade(10, 12, 16, 90);

/// Draws lines of the world, also where they pass the eye or go far out of the picture.
class WorldPen {
public:
    WorldPen(QPainter& painter, const View& view)
        : m_painter(painter), m_view(view.shownCamera()), m_axes(cameraAxes(m_view)), m_width(std::max(1, view.width())),
          m_height(std::max(1, view.height())) {}

    void line(Vec3 a, Vec3 b, const QColor& colour, double width) const {
        const double depthA = depthOf(a), depthB = depthOf(b);
        if (depthA < kLeastDepth && depthB < kLeastDepth) return;
        const Vec3 cut = a + (b - a) * ((kLeastDepth - depthA) / (depthB - depthA));
        if (depthA < kLeastDepth) a = cut;
        if (depthB < kLeastDepth) b = cut;
        const auto from = project(m_view, m_width, m_height, a), to = project(m_view, m_width, m_height, b);
        if (!from || !to) return;
        QLineF shown(from->x, from->y, to->x, to->y);
        if (!clip(shown)) return;
        for (const auto& [ink, wide] : {std::pair(kFrustumShade, width + 1.6), {colour, width}}) {
            m_painter.setPen(QPen(ink, wide, Qt::SolidLine, Qt::RoundCap));
            m_painter.drawLine(shown);
        }
    }

private:
    static constexpr double kLeastDepth = 1e-3; // m

    [[nodiscard]] double depthOf(const Vec3& point) const { return -m_axes.col(2).dot(point - m_view.eye); }
    /// To the picture and a little around it (Liang and Barsky).
    [[nodiscard]] bool clip(QLineF& line) const {
        double from = 0, to = 1;
        const double rim = 8;
        const auto edge = [&](double along, double room) {
            if (along == 0) return room >= 0;
            const double at = room / along;
            if (along < 0) from = std::max(from, at);
            else to = std::min(to, at);
            return from < to;
        };
        if (!edge(-line.dx(), line.x1() + rim) || !edge(line.dx(), m_width + rim - line.x1()) ||
            !edge(-line.dy(), line.y1() + rim) || !edge(line.dy(), m_height + rim - line.y1()))
            return false;
        line = QLineF(line.pointAt(from), line.pointAt(to));
        return true;
    }

    QPainter& m_painter;
    CameraView m_view;
    Mat3 m_axes;
    std::uint32_t m_width, m_height;
};

void paintFrustum(const WorldPen& pen, const CameraModel& camera, const Pose& body, const QColor& colour, double width) {
    const Pose lens = body * camera.mounting;
    const double wide = std::tan(0.5 * camera.fieldOfView), high = wide * camera.height / std::max(1u, camera.width);
    const auto corner = [&](double depth, int i) {
        const double left = i == 0 || i == 3 ? 1 : -1, up = i < 2 ? 1 : -1;
        return lens * Vec3(depth, left * wide * depth, up * high * depth);
    };
    for (int i = 0; i < 4; ++i) {
        pen.line(corner(camera.nearPlane, i), corner(camera.farPlane, i), colour, width);
        for (const double plane : {camera.nearPlane, camera.farPlane})
            pen.line(corner(plane, i), corner(plane, (i + 1) % 4), colour, width);
    }
}

} // namespace

void paintFrusta(QPainter& painter, const View& view, bool all) {
    const ShownWorld& world = view.parts().world;
    std::set<const CameraModel*> selected;
    for (const std::string& path : view.parts().selection.paths())
        for (const CameraModel* camera : world.camerasOf(path)) selected.insert(camera);
    // Those of a whole swarm say nothing, nor do others while one looks through a camera: whoever wants them switches them on.
    if (!all && (selected.empty() || selected.size() > kMostUnasked || view.throughCamera())) return;
    const WorldPen pen(painter, view);
    const BodyPoses& poses = view.shownPoses();
    std::size_t shown = 0;
    for (const CameraModel& camera : world.cameras()) {
        const bool marked = selected.contains(&camera);
        const auto robot = world.find(camera.robot);
        if ((!all && !marked) || &camera == view.throughCamera() || camera.body >= poses.size()) continue;
        if ((robot && world.isHidden(*robot)) || ++shown > kMostFrusta) continue;
        paintFrustum(pen, camera, poses[camera.body], marked ? View::outlineColour() : kFrustum, marked ? 1.3 : 1);
    }
}

} // namespace trundle
