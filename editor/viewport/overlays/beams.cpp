#include "editor/viewport/overlays/beams.h"

#include <array>
#include <cmath>
#include <numbers>

#include <QPainter>

#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxSensors = 200, kMaxSelectedSensors = 40;
constexpr std::size_t kMaxBeamLines = 48;   // of a sensor; of more beams every n-th is a line, fainter
constexpr double kSurfaceGap = 0.2;         // of the distance
constexpr int kConeSides = 24;
constexpr double kMaxReadingAge = 2; // s; an older reading is drawn where its sensor is now
const QColor kBeam(226, 68, 92);

QColor translucent(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

/// One sensor, its frame in the world and its distances.
struct DrawnSensor {
    const ScenePainter& pen;
    QPainter& painter;
    const RangeModel& sensor;
    Pose eye;
    std::span<const double> distances;
    QColor colour;

    [[nodiscard]] double distance(std::size_t beam) const {
        return beam < distances.size() ? std::clamp(distances[beam], 0.0, sensor.maxRange) : sensor.maxRange;
    }
    [[nodiscard]] bool hits(std::size_t beam) const { return beam < distances.size() && distances[beam] < sensor.maxRange; }

    /// Two beams side by side met different surfaces.
    [[nodiscard]] bool isApart(double a, double b) const {
        return std::abs(a - b) > kSurfaceGap * std::min(a, b) + 0.01 * sensor.maxRange;
    }

    /// All lines to and from the sensor together must leave the picture behind them readable.
    void fan() const {
        std::vector<Vec3> echoes, area, surface;
        std::vector<bool> ends;
        const std::size_t count = std::size_t(sensor.beams) * sensor.layers, step = (count + kMaxBeamLines - 1) / kMaxBeamLines;
        const bool many = step > 1;
        for (std::uint32_t layer = 0; layer < sensor.layers; ++layer) {
            area.clear();
            surface.clear();
            ends.clear();
            if (!sensor.closed) area.push_back(eye.position);
            for (std::uint32_t i = 0; i < sensor.beams; ++i) {
                const std::size_t beam = std::size_t(layer) * sensor.beams + i;
                const Vec3 end = eye * (distance(beam) * sensor.directions[beam]);
                area.push_back(end);
                if (many) {
                    surface.push_back(end);
                    ends.push_back(i + 1 == sensor.beams || isApart(distance(beam), distance(beam + 1)));
                }
                if (hits(beam)) echoes.push_back(end);
                if (!many) pen.line(eye.position, end, translucent(colour, 150), 1);
                else if (beam % step == 0) faint(end);
            }
            const QPen outline(translucent(colour, sensor.layers > 1 ? 60 : 130), 1);
            painter.setPen(many ? QPen(Qt::NoPen) : outline);
            painter.setBrush(translucent(colour, std::max(1, (many ? 8 : 34) / int(sensor.layers))));
            painter.setRenderHint(QPainter::Antialiasing, !many); // hundreds of smooth corners take milliseconds
            pen.polygon(area);
            painter.setPen(outline);
            if (many) pen.path(surface, ends); // lines between surfaces show nothing
            painter.setRenderHint(QPainter::Antialiasing);
        }
        pen.dots(echoes, colour, 3);
    }

    void faint(const Vec3& end) const {
        painter.setPen(QPen(translucent(colour, 60), 1));
        pen.path(std::array{eye.position, end}, {false, true});
    }

    void cone() const {
        const double length = distance(0), half = sensor.coneAngle / 2;
        const Vec3 end = eye * Vec3(length, 0, 0);
        std::vector<Vec3> rim;
        for (int i = 0; half > 0 && i < kConeSides; ++i) {
            const double around = 2 * std::numbers::pi * i / kConeSides;
            rim.push_back(eye *
                          (length * Vec3(std::cos(half), std::sin(half) * std::cos(around), std::sin(half) * std::sin(around))));
        }
        painter.setPen(QPen(translucent(colour, 170), 1));
        painter.setBrush(translucent(colour, 40));
        if (!rim.empty()) pen.polygon(rim);
        for (std::size_t i = 0; i < rim.size(); i += kConeSides / 4) pen.line(eye.position, rim[i], translucent(colour, 170), 1);
        if (rim.empty()) pen.line(eye.position, end, colour, 1.3);
        if (hits(0)) pen.dots({&end, 1}, colour, 5);
    }

    /// A dot at the sensor, as bright as what it measures.
    void dot() const {
        const double share = distances.empty() ? 0 : std::clamp(distances[0], 0.0, 1.0);
        const int grey = static_cast<int>(std::lround(255 * std::sqrt(share))); // the display colour of this light
        pen.dots({&eye.position, 1}, colour, 11);
        if (!distances.empty()) pen.dots({&eye.position, 1}, QColor(grey, grey, grey), 7);
    }
};

const double* slotsOf(const SignalLayout& layout, const LiveSnapshot& snapshot, const std::string& path, std::uint32_t count) {
    const auto entry = layout.find(path);
    return entry && entry->count == count ? snapshot.block->slots().data() + entry->offset : nullptr;
}

} // namespace

std::span<const double> distancesOf(const RangeModel& sensor, const SignalLayout& layout, const LiveSnapshot& snapshot) {
    const auto count = static_cast<std::uint32_t>(sensor.directions.size());
    const double* time = slotsOf(layout, snapshot, sensor.path + "/time", 1);
    const double* distances = slotsOf(layout, snapshot, sensor.signal(), count);
    const bool hasReading = !time || *time >= 0;
    return distances && hasReading ? std::span(distances, count) : std::span<const double>();
}

Pose poseAtReading(const RangeModel& sensor, const std::string& bodyName, const SignalLayout& layout,
                   const LiveSnapshot& snapshot, const Pose& body) {
    const double* time = slotsOf(layout, snapshot, sensor.path + "/time", 1);
    const double* velocity = slotsOf(layout, snapshot, sensor.robot + "/" + bodyName + "/velocity", 6);
    const double age = time ? snapshot.time - *time : 0;
    if (!velocity || !(age > 0 && age < kMaxReadingAge)) return body;
    const Vec3 linear(velocity), turn = -age * Vec3(velocity + 3);
    const Quat back = turn.norm() > 0 ? Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) : Quat(Quat::Identity());
    return {body.position - age * linear, (back * body.rotation).normalized()};
}

void paintBeams(QPainter& painter, const ToolView& view, bool all) {
    const ViewportScene& world = view.context().world;
    const std::vector<std::string>& paths = view.context().selection.paths();
    if (world.rangeSensors().empty() || (!all && paths.empty())) return;
    const RunResults& results = view.context().session.results();
    const bool live = world.isRunning() && results.layout && results.snapshot;
    const ScenePainter pen(painter, view);
    const BodyPoses& poses = view.shownPoses();
    std::size_t shown = 0;
    for (const RangeModel& sensor : world.rangeSensors()) {
        const auto refersTo = [&](const std::string& path) {
            return world.isPartOf(path, sensor.robot, sensor.body, sensor.path);
        };
        const bool marked = std::ranges::any_of(paths, refersTo);
        const auto robot = world.find(sensor.robot);
        if ((!all && !marked) || sensor.body >= poses.size() || !robot || world.isHidden(*robot)) continue;
        if (++shown > (all ? kMaxSensors : kMaxSelectedSensors)) break;
        const std::uint32_t own = *world.objects()->bodiesOf(*robot);
        const std::string& body =
            world.objects()->experiment().robots[own].config->bodies[sensor.body - world.objects()->firstPose(own)].name;
        Pose at = poses[sensor.body];
        std::span<const double> distances;
        if (live) {
            distances = distancesOf(sensor, *results.layout, *results.snapshot);
            if (!distances.empty()) at = poseAtReading(sensor, body, *results.layout, *results.snapshot, at);
        }
        const DrawnSensor drawn{
            pen, painter, sensor, at * sensor.mounting, distances, marked ? ToolView::outlineColour() : kBeam};
        if (sensor.ground) drawn.dot();
        else if (sensor.beams > 0) drawn.fan();
        else drawn.cone();
    }
}

} // namespace trundle
