#include "devices/lidar.h"

#include <algorithm>
#include <numbers>

namespace trundle {

namespace {

constexpr double kFullCircle = 2 * std::numbers::pi;
constexpr std::uint64_t kRangeDraws = 3; // random numbers that RangeNoise takes for each distance

/// Angles spread over a field of view: the first, and the step to the next one.
struct Spread {
    double first = 0, step = 0; ///< rad
};

/// Number of steps in a field of view: around a full circle the last one leads back to the first bearing.
int stepsOf(double fieldOfView, int count) { return fieldOfView > kFullCircle * (1 - 1e-9) ? count : count - 1; }

Spread spreadOver(double fieldOfView, int count) {
    if (count < 2) return {};
    return {-fieldOfView / 2, fieldOfView / stepsOf(fieldOfView, count)};
}

} // namespace

Lidar::Lidar() : m_fieldOfView(kFullCircle), m_verticalFieldOfView(kFullCircle / 12) {}

void Lidar::describe(Describe<Lidar>& d) {
    d.help("Measures distances along many beams that spread from one point.").independent();
    describeSensor(d);
    Quantity beams = number().within(1, 100000), layers = number().within(1, 1000);
    beams.type = layers.type = TRUNDLE_INTEGER;
    d.field("Beams", &Lidar::m_beams, beams, "Beams in a layer, from -FieldOfView/2 counter-clockwise.");
    d.field("FieldOfView", &Lidar::m_fieldOfView, degrees().above(0).atMost(360),
            "From the first beam to the last; at 360 the last is one step before the first.");
    d.field("Layers", &Lidar::m_layers, layers, "Layers of beams, from below.");
    d.field("VerticalFieldOfView", &Lidar::m_verticalFieldOfView, degrees().within(0, 180),
            "From the lowest layer to the highest; a single layer is level.");
    d.field("MinRange", &Lidar::m_minRange, metres().within(0, 1e5), "What is nearer reads as this.");
    d.field("MaxRange", &Lidar::m_maxRange, metres().above(0).atMost(1e5), "What is farther is not seen and reads as this.");
    d.field("SweepTime", &Lidar::m_sweepTime, seconds().within(0, 1e3),
            "Time in which it turns from the first bearing to the last, while it and everything else moves; 0: all at once.");
    d.field("Intensity", &Lidar::m_hasIntensity, flag(), "Gives the intensities of the echoes too.");
    d.field("IntensityNoise", &Lidar::m_intensityNoise, number().within(0, 10), "Standard deviation of an intensity.");
    d.field("Objects", &Lidar::m_hasObjects, flag(),
            "Gives the numbers of the objects that it hits too, which no real one measures.");
    describeNoise(d);
    LidarSignals::describe(d);
}

void Lidar::begin(Mount& mount) {
    if (!(m_minRange < m_maxRange)) mount.fail("MinRange must be smaller than MaxRange");
    const Spread across = spreadOver(m_fieldOfView, m_beams);
    Spread up;
    if (m_layers > 1) up = {-m_verticalFieldOfView / 2, m_verticalFieldOfView / (m_layers - 1)};
    m_fan.range = m_maxRange;
    m_fan.firstBearing = across.first;
    m_fan.bearingStep = across.step;
    m_fan.count = static_cast<std::uint32_t>(m_beams);
    m_fan.elevations.clear();
    for (int i = 0; i < m_layers; ++i)
        m_fan.elevations.push_back(std::clamp(up.first + i * up.step, -kFullCircle / 4, kFullCircle / 4));
    m_part = m_fan;
    m_distances.assign(m_fan.size(), m_maxRange);
    m_partDistances = m_distances;
    if (m_hasIntensity || m_hasObjects) m_geoms.resize(m_fan.size());
    if (m_hasIntensity) m_normals.resize(m_fan.size());
    m_intensity.assign(m_hasIntensity ? m_fan.size() : 0, 0);
    m_object.assign(m_hasObjects ? m_fan.size() : 0, 0);
    if (m_sweepTime > interval(mount.tick().value) * (1 + 1e-9))
        mount.fail("SweepTime is longer than UpdatePeriod, or without one than the tick");
    for (std::uint32_t i = 0; i < ranges.count(); ++i) ranges.set(i, m_maxRange);
    time.set(-1);
}

/// One that lost its power begins its sweep again.
void Lidar::follow(Sensing& world) {
    if (world.supply().powered()) castPassed(world);
    else m_cast = 0;
}

/// Casts what it has passed of the sweep that ends with the reading after this tick. A single bearing is that of the end.
void Lidar::castPassed(Sensing& world) {
    if (!(m_sweepTime > world.tick()) || m_beams < 2) return; // within one tick nothing moves
    const double period = interval(world.tick()), slack = 1e-6 * world.tick();
    const double due = (std::floor((world.time() + slack) / period) + 1) * period;
    const double passed = std::floor((1 - (due - world.time()) / m_sweepTime) * stepsOf(m_fieldOfView, m_beams) + 1e-6);
    if (passed < 0) return;
    cast(world, m_cast, std::min(m_fan.count, static_cast<std::uint32_t>(passed) + 1));
}

/// Bearings from `first` to before `end`, of all layers.
void Lidar::cast(Sensing& world, std::uint32_t first, std::uint32_t end) {
    if (end <= first) return;
    const Pose eye = pose(world);
    m_part.firstBearing = m_fan.firstBearing + first * m_fan.bearingStep;
    m_part.count = end - first;
    const std::size_t size = m_part.size();
    const auto sized = [&](auto& all) { return std::span(all).first(std::min(all.size(), size)); };
    std::fill_n(m_partDistances.begin(), size, m_maxRange);
    world.castFan(m_part, eye, {sized(m_partDistances), sized(m_geoms), sized(m_normals)});
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t beam = i / m_part.count * m_fan.count + first + i % m_part.count;
        m_distances[beam] = m_partDistances[i];
        if (m_geoms.empty()) continue;
        const Vec3 direction = eye.rotation * m_part.direction(i);
        if (m_hasIntensity)
            m_intensity[beam] = m_geoms[i]
                                    ? world.reflectance(m_geoms[i], eye.position + m_partDistances[i] * direction, m_normals[i]) *
                                          std::max(0.0, -direction.dot(m_normals[i]))
                                    : 0;
        if (!m_hasObjects) continue;
        TrundleGeomInfo info;
        m_object[beam] = m_geoms[i] && world.geomInfo(m_geoms[i], info) ? info.object : 0;
    }
    m_cast = end;
}

void Lidar::measure(Sensing& world, std::vector<double>& reading) {
    cast(world, m_cast, m_fan.count);
    m_cast = 0;
    const std::size_t size = m_fan.size();
    for (std::size_t i = 0; i < size; ++i) reading.push_back(apply(m_distances[i], m_minRange, m_maxRange, world, i));
    for (std::size_t i = 0; i < m_intensity.size(); ++i) { // none of a beam that reads nothing
        const bool isLost = !(reading[i] < m_maxRange);
        const double error =
            m_intensityNoise > 0 ? m_intensityNoise * normalDeviate(world.randomBits(kRangeDraws * size + i)) : 0;
        reading.push_back(isLost ? 0 : std::max(0.0, m_intensity[i] + error));
    }
    reading.insert(reading.end(), m_object.begin(), m_object.end());
    castPassed(world); // the next sweep may begin as this one ends
}

void Lidar::publish(std::span<const double> reading, double measured) {
    const std::size_t size = m_fan.size();
    for (std::size_t i = 0; i < size; ++i) ranges.set(static_cast<std::uint32_t>(i), reading[i]);
    for (std::size_t i = 0; i < m_intensity.size(); ++i) intensities.set(static_cast<std::uint32_t>(i), reading[size + i]);
    const std::size_t first = size + m_intensity.size();
    for (std::size_t i = 0; i < m_object.size(); ++i) objects.set(static_cast<std::uint32_t>(i), reading[first + i]);
    time.set(measured);
}

} // namespace trundle
