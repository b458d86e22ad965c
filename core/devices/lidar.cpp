#include "devices/lidar.h"

#include <numbers>

namespace trundle {

namespace {

constexpr double kFullCircle = 2 * std::numbers::pi;

/// Angles spread over a field of view: the first, and the step to the next one.
struct Spread {
    double first = 0, step = 0; ///< rad
};

Spread spreadOver(double fieldOfView, int count) {
    if (count < 2) return {};
    const bool closed = fieldOfView > kFullCircle * (1 - 1e-9);
    return {-fieldOfView / 2, fieldOfView / (closed ? count : count - 1)};
}

} // namespace

Lidar::Lidar() : m_fieldOfView(kFullCircle), m_verticalFieldOfView(kFullCircle / 12) {}

void Lidar::describe(Describe<Lidar>& d) {
    d.help("Measures distances along many beams that spread from one point.");
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
    for (std::uint32_t i = 0; i < ranges.count(); ++i) ranges.set(i, m_maxRange);
    time.set(-1);
}

void Lidar::measure(Sensing& world, std::vector<double>& reading) {
    reading.resize(m_fan.size(), m_maxRange);
    world.castFan(m_fan, pose(world), {reading});
    for (std::size_t i = 0; i < reading.size(); ++i) reading[i] = apply(reading[i], m_minRange, m_maxRange, world, i);
}

void Lidar::publish(std::span<const double> reading, double measured) {
    for (std::size_t i = 0; i < reading.size(); ++i) ranges.set(static_cast<std::uint32_t>(i), reading[i]);
    time.set(measured);
}

} // namespace trundle
