#include "devices/light_sensor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trundle {

namespace {

constexpr double kLux = 1000;     // of a light of 1, as in a bright room
constexpr double kFarthest = 1e4; // m: what is farther casts no shadow of the sun
constexpr int kParts = 200;

} // namespace

void LightSensor::describe(Describe<LightSensor>& d) {
    d.help("Measures how bright it is in front of it.").independent();
    describeSensor(d);
    d.field("Exponent", &LightSensor::m_exponent, number().within(0, 1000),
            "It weighs light by this power of the cosine of its angle from the x axis; 1: as a flat surface, more: narrower.");
    d.field("MaxIlluminance", &LightSensor::m_maxIlluminance, unitOf("lx").above(0).atMost(1e9),
            "What is brighter reads as this.");
    d.field("Noise", &LightSensor::m_noise, unitOf("lx").within(0, 1e9), "Standard deviation of a reading.");
    d.field("NoiseShare", &LightSensor::m_noiseShare, number().within(0, 10),
            "Grows the standard deviation by this share of the reading.");
    d.field("Resolution", &LightSensor::m_resolution, unitOf("lx").within(0, 1e9), "Readings are multiples of it; 0: exact.");
    LightSensorSignals::describe(d);
}

void LightSensor::begin(Mount&) {
    time.set(-1);
    if (m_exponent == 1) return;
    for (int i = 0; i < kParts; ++i) {
        const double cosine = std::pow((i + 0.5) / kParts, 1 / (m_exponent + 1));
        m_cotangents.push_back(cosine / std::sqrt(1 - cosine * cosine));
    }
}

/// Of what it sees, weighed, the share above the horizon; `up`: the upward part of its axis. Method: of each cone about its axis the part
/// that is above, summed over cones of equal weight.
double LightSensor::shareFromAbove(double up) const {
    if (m_cotangents.empty()) return (1 + up) / 2;
    const double slope = up / std::sqrt(std::max(1 - up * up, 1e-18));
    double sum = 0;
    for (const double cotangent : m_cotangents) sum += std::acos(std::clamp(-cotangent * slope, -1.0, 1.0));
    return sum / (std::numbers::pi * kParts);
}

double LightSensor::response(double cosine) const { return cosine > 0 ? std::pow(cosine, m_exponent) : 0; }

/// Its reading: with errors, and the true one.
void LightSensor::measure(Sensing& world, std::vector<double>& reading) {
    const Pose eye = pose(world);
    const Vec3 normal = eye.rotation * Vec3::UnitX();
    const double wide = 2 / (m_exponent + 1); // of light from everywhere, relative to a flat surface
    world.lights(m_lights);
    world.beams(m_beams);
    m_rays.reserve(m_lights.size());
    m_shares.reserve(m_lights.size());
    m_distances.reserve(m_lights.size());
    m_rays.clear();
    m_shares.clear();
    double sum = 0;
    for (std::size_t i = 0; i < m_lights.size(); ++i) {
        const TrundleLight& light = m_lights[i];
        if (light.type == TRUNDLE_SKY || light.type == TRUNDLE_GROUND) {
            const double above = shareFromAbove(std::clamp(normal.z(), -1.0, 1.0));
            sum += light.light * wide * (light.type == TRUNDLE_SKY ? above : 1 - above);
            continue;
        }
        const bool isLamp = light.type == TRUNDLE_LAMP;
        const Vec3 way = isLamp ? Vec3(Vec3(light.way) - eye.position) : Vec3(light.way);
        const double distance = way.norm();
        if (!(distance > 1e-6)) continue; // in the lamp
        const double sent = light.light * (isLamp ? shareAlong(m_beams[i], -way / distance) : 1);
        const double share = sent * response(normal.dot(way) / distance) / (isLamp ? distance * distance : 1);
        if (!(share > 0)) continue;
        if (!light.shadows || (isLamp && distance <= m_beams[i].radius)) {
            sum += share;
            continue;
        }
        m_rays.push_back({eye.position, way / distance, isLamp ? distance - m_beams[i].radius : kFarthest});
        m_shares.push_back(share);
    }
    m_distances.resize(m_rays.size());
    for (std::size_t i = 0; i < m_rays.size(); ++i) m_distances[i] = m_rays[i].range;
    world.castRays(m_rays, {m_distances});
    for (std::size_t i = 0; i < m_rays.size(); ++i)
        if (m_distances[i] >= m_rays[i].range) sum += m_shares[i];
    const double exact = kLux * sum, sigma = m_noise + m_noiseShare * exact;
    const double measured = sigma > 0 ? exact + sigma * normalDeviate(world.randomBits(0)) : exact;
    reading = {roundedWithin(measured, 0, m_maxIlluminance, m_resolution), exact};
}

void LightSensor::publish(std::span<const double> reading, double measured) {
    illuminance.set(reading[0]);
    trueIlluminance.set(reading[1]);
    time.set(measured);
}

} // namespace trundle
