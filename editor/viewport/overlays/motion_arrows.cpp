#include "editor/viewport/overlays/motion_arrows.h"

#include <algorithm>

#include <QColor>
#include <QWidget>

#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxArrowSensors = 40;
constexpr double kPixelsPerAcceleration = 60 / 9.81, kPixelsPerRate = 40; // per m/s^2, per rad/s
constexpr double kMostArrowPixels = 160;
const QColor kAcceleration(255, 120, 40), kRate(190, 120, 255);

Vec3 vectorProperty(const ComponentSpec& device, std::string_view key) {
    const ResolvedValue* value = device.find(key);
    return value && value->value.numbers.size() == 3 ? Vec3(value->value.numbers.data()) : Vec3(Vec3::Zero());
}

/// The inertial sensors of one robot.
class MotionArrows {
public:
    MotionArrows(QPainter& painter, const ToolView& view, const SignalLayout& layout, const LiveSnapshot& snapshot)
        : m_pen(painter, view), m_view(view), m_layout(layout), m_snapshot(snapshot) {}

    void paint(const RobotSpec& robot, const ComponentSpec& device, const Pose& body) {
        const Pose at = body * Pose{vectorProperty(device, "Pos"), rotationFromHpr(vectorProperty(device, "HPR"))};
        const std::string path = robot.name + "/" + device.name + "/";
        arrow(at, path + "acceleration", kPixelsPerAcceleration, kAcceleration);
        arrow(at, path + "angularVelocity", kPixelsPerRate, kRate);
    }

private:
    void arrow(const Pose& at, const std::string& signal, double pixelsPerUnit, const QColor& colour) const {
        const auto entry = m_layout.find(signal);
        if (!entry || entry->count != 3) return;
        const Vec3 vector = at.rotation * Vec3(m_snapshot.block->slots().data() + entry->offset);
        const double length = std::min(vector.norm() * pixelsPerUnit, kMostArrowPixels);
        if (!(length > 2)) return;
        const double perPixel = m_view.camera().free().metresPerPixel(m_view.widget().width(), at.position);
        const Vec3 along = perPixel * vector.normalized(), tip = at.position + length * along;
        const Vec3 side = perPixel * along.cross(tip - m_view.shownCamera().eye).normalized();
        m_pen.line(at.position, tip, colour, 2);
        for (const double sign : {-1.0, 1.0}) m_pen.line(tip, tip - 8 * along + sign * 4 * side, colour, 2);
    }

    ScenePainter m_pen;
    const ToolView& m_view;
    const SignalLayout& m_layout;
    const LiveSnapshot& m_snapshot;
};

} // namespace

void paintMotionArrows(QPainter& painter, const ToolView& view) {
    const ViewportScene& world = view.context().world;
    const std::vector<std::string>& paths = view.context().selection.paths();
    const RunResults& results = view.context().session.results();
    if (paths.empty() || !world.isRunning() || !results.layout || !results.snapshot) return;
    MotionArrows arrows(painter, view, *results.layout, *results.snapshot);
    std::size_t shown = 0;
    const auto& robots = world.objects()->experiment().robots;
    for (std::uint32_t r = 0; r < robots.size(); ++r) {
        const RobotSpec& robot = robots[r];
        if (!robot.config || world.isHidden({ObjectKind::Robot, r})) continue;
        for (const ComponentSpec& device : robot.config->devices) {
            if (device.kind != "Imu") continue;
            const auto body = std::ranges::find(robot.config->bodies, device.text("Body"), &BodySpec::name);
            if (body == robot.config->bodies.end()) continue;
            const auto index = static_cast<std::uint32_t>(body - robot.config->bodies.begin());
            const std::size_t pose = world.objects()->firstPose(r) + index;
            const auto refersTo = [&](const std::string& path) {
                return world.isPartOf(path, robot.name, pose, robot.name + "/" + device.name);
            };
            if (!std::ranges::any_of(paths, refersTo)) continue;
            if (++shown > kMaxArrowSensors) return;
            arrows.paint(robot, device, world.objects()->poseOf({ObjectKind::Body, r, index}, view.shownPoses()));
        }
    }
}

} // namespace trundle
