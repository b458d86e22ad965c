#include "devices/compass.h"

#include <numbers>

namespace trundle {

void Compass::describe(Describe<Compass>& d) {
    d.help("Measures the heading of its x axis over the floor.").independent();
    describeSensor(d);
    d.field("Noise", &Compass::m_noise, degrees().within(0, 360), "Standard deviation of a heading.");
    d.field("Bias", &Compass::m_bias, degrees().within(-360, 360), "Added to every heading.");
    d.field("Resolution", &Compass::m_resolution, degrees().within(0, 360), "Readings are multiples of it; 0: exact.");
    CompassSignals::describe(d);
}

void Compass::begin(Mount&) { time.set(-1); }

void Compass::measure(Sensing& world, std::vector<double>& reading) {
    const Vec3 ahead = pose(world).rotation * Vec3::UnitX();
    double heading = std::atan2(ahead.y(), ahead.x()) + m_bias;
    if (m_noise > 0) heading += m_noise * normalDeviate(world.randomBits(0));
    reading.push_back(std::remainder(roundedTo(heading, m_resolution), 2 * std::numbers::pi));
}

void Compass::publish(std::span<const double> reading, double measured) {
    heading.set(reading[0]);
    time.set(measured);
}

} // namespace trundle
