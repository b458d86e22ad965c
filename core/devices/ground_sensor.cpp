#include "devices/ground_sensor.h"

#include <numbers>

namespace trundle {

namespace {

constexpr int kSpotRings = 4;

} // namespace

std::vector<Vec3> placesOnDisc(double diameter) {
    std::vector<Vec3> all;
    if (!(diameter > 0)) return {Vec3::Zero()};
    for (int ring = 0; ring < kSpotRings;
         ++ring) { // each between two radii whose squares grow evenly with the number of its points
        const int count = ring == 0 ? 4 : 4 * (2 * ring + 1);
        const double inner = static_cast<double>(ring) / kSpotRings, outer = (ring + 1.0) / kSpotRings;
        const double radius = diameter / 2 * std::sqrt((inner * inner + outer * outer) / 2);
        for (int i = 0; i < count; ++i) {
            const double around = 2 * std::numbers::pi * (i + 0.37 * ring) / count; // no two rings in line
            all.push_back({radius * std::cos(around), radius * std::sin(around), 0});
        }
    }
    return all;
}

void GroundSensor::describe(Describe<GroundSensor>& d) {
    d.help("Measures how much light the floor below it returns.").independent();
    describeSensor(d);
    d.field("MaxHeight", &GroundSensor::m_maxHeight, metres().above(0).atMost(1e3), "A floor farther below it is not seen: 0.");
    d.field("Spot", &GroundSensor::m_spot, metres().within(0, 1e3), "Diameter of what it sees, on average; 0: a point.");
    d.field("Noise", &GroundSensor::m_noise, number().within(0, 10), "Standard deviation of a reading.");
    d.field("Resolution", &GroundSensor::m_resolution, number().within(0, 1), "Readings are multiples of it; 0: exact.");
    GroundSensorSignals::describe(d);
}

void GroundSensor::begin(Mount&) {
    m_places = placesOnDisc(m_spot);
    m_rays.resize(m_places.size());
    m_distances.resize(m_places.size());
    m_geoms.resize(m_places.size());
    m_normals.resize(m_places.size());
    time.set(-1);
}

/// Its reading: with errors, and the true one.
void GroundSensor::measure(Sensing& world, std::vector<double>& reading) {
    const Pose eye = pose(world);
    const Vec3 down = eye.rotation * -Vec3::UnitZ();
    for (std::size_t i = 0; i < m_rays.size(); ++i) m_rays[i] = {eye * m_places[i], down, m_maxHeight};
    world.castRays(m_rays, {m_distances, m_geoms, m_normals});
    double sum = 0;
    for (std::size_t i = 0; i < m_rays.size(); ++i)
        if (m_geoms[i]) sum += world.reflectance(m_geoms[i], m_rays[i].origin + m_distances[i] * down, m_normals[i]);
    const double exact = sum / static_cast<double>(m_rays.size());
    double measured = exact;
    if (m_noise > 0) measured += m_noise * normalDeviate(world.randomBits(0));
    reading = {roundedWithin(measured, 0, 1, m_resolution), exact};
}

void GroundSensor::publish(std::span<const double> reading, double measured) {
    reflectance.set(reading[0]);
    trueReflectance.set(reading[1]);
    time.set(measured);
}

} // namespace trundle
