#include "devices/range_sensor.h"

#include <numbers>

namespace trundle {

namespace {

constexpr double kUltrasonicCone = std::numbers::pi / 6, kSmoothWall = std::numbers::pi * 50 / 180; // rad
constexpr int kRings = 5;

/// Sharp GP2Y0A21YK0F, data sheet E4-A00201EN: typically 0.4 V at 80 cm and 1.9 V more at 10 cm; in between the voltage is linear
/// in 1 / (distance + 0.42 cm).
constexpr double kSharpCurve[] = {0.1, 2.3, 0.8, 0.4};
constexpr double kSharpOffset = 0.0042; // m

} // namespace

std::vector<Vec3> directionsInCone(double coneAngle) {
    std::vector<Vec3> all{Vec3::UnitX()};
    if (!(coneAngle > 0)) return all;
    for (int ring = 1; ring <= kRings; ++ring) {
        const double off = coneAngle / 2 * ring / kRings;
        for (int i = 0; i < 6 * ring; ++i) {
            const double around = i * std::numbers::pi / (3 * ring);
            all.push_back({std::cos(off), std::sin(off) * std::cos(around), std::sin(off) * std::sin(around)});
        }
    }
    return all;
}

RangeSensor::RangeSensor() : m_maxIncidence(kSmoothWall), m_voltageCurve(std::begin(kSharpCurve), std::end(kSharpCurve)) {}

void RangeSensor::describe(Describe<RangeSensor>& d) {
    d.help("Measures the distance of what is in front of it, by infrared light or ultrasound.").independent();
    describeSensor(d);
    d.field("Type", &RangeSensor::m_type, oneOf("infrared|ultrasonic"),
            "Infrared: a thin beam. Ultrasonic: the nearest echo in a cone.");
    d.field("MinRange", &RangeSensor::m_minRange, metres().within(0, 1e5),
            "What is nearer reads as this; its ultrasonic echo is lost.");
    d.field("MaxRange", &RangeSensor::m_maxRange, metres().above(0).atMost(1e5),
            "What is farther is not seen and reads as this.");
    d.field("ConeAngle", &RangeSensor::m_coneAngle, degrees().within(0, 170),
            "Width of its cone; not given: 0 for infrared, 30 for ultrasonic.");
    d.field("MaxIncidence", &RangeSensor::m_maxIncidence, degrees().within(0, 90),
            "An ultrasonic echo is lost where the surface is hit at more than this from its normal.");
    d.field("VoltageCurve", &RangeSensor::m_voltageCurve, number().within(0, 1e5).counted(4, 1000),
            "Infrared: distance [m], voltage [V], and so on, by increasing distance; by default that of a Sharp GP2Y0A21.");
    describeNoise(d);
    RangeSensorSignals::describe(d);
}

void RangeSensor::begin(Mount& mount) {
    if (!(m_minRange < m_maxRange)) mount.fail("MinRange must be smaller than MaxRange");
    bool isCurve = m_voltageCurve.size() % 2 == 0;
    for (std::size_t i = 2; isCurve && i < m_voltageCurve.size(); i += 2) isCurve = m_voltageCurve[i - 2] < m_voltageCurve[i];
    if (!isCurve) mount.fail("VoltageCurve must be pairs of a distance and a voltage, with increasing distances");
    m_isUltrasonic = m_type == "ultrasonic";
    m_directions = directionsInCone(m_coneAngle.value_or(m_isUltrasonic ? kUltrasonicCone : 0));
    m_rays.resize(m_directions.size());
    m_distances.resize(m_directions.size());
    m_normals.resize(m_directions.size());
    m_geoms.resize(m_directions.size());
    const double nothing[] = {m_maxRange, m_maxRange, 0};
    publish(nothing, -1);
}

/// Its reading: the range, and the true distance of the nearest surface with the number of its object.
void RangeSensor::measure(Sensing& world, std::vector<double>& reading) {
    const Pose eye = pose(world);
    for (std::size_t i = 0; i < m_rays.size(); ++i) m_rays[i] = {eye.position, eye.rotation * m_directions[i], m_maxRange};
    std::ranges::fill(m_distances, m_maxRange);
    world.castRays(m_rays, {m_distances, m_geoms, m_normals});
    double nearest = m_maxRange, echo = m_maxRange;
    GeomId seen;
    for (std::size_t i = 0; i < m_rays.size(); ++i) {
        const double distance = m_distances[i];
        if (distance < nearest) {
            nearest = distance;
            seen = m_geoms[i];
        }
        if (m_isUltrasonic) {
            const double cosine = std::abs(m_normals[i].dot(m_rays[i].direction));
            if (distance < m_minRange || cosine < std::cos(m_maxIncidence) - 1e-12) continue;
        }
        echo = std::min(echo, distance);
    }
    TrundleGeomInfo info;
    const double number = seen && world.geomInfo(seen, info) ? info.object : 0;
    reading = {apply(echo, m_minRange, m_maxRange, world, 0), nearest, number};
}

void RangeSensor::publish(std::span<const double> reading, double measured) {
    range.set(reading[0]);
    voltage.set(m_isUltrasonic ? 0 : voltageAt(reading[0]));
    trueRange.set(reading[1]);
    object.set(static_cast<std::int64_t>(reading[2]));
    time.set(measured);
}

double RangeSensor::voltageAt(double distance) const {
    const std::vector<double>& curve = m_voltageCurve;
    std::size_t next = 0;
    while (next < curve.size() && curve[next] < distance) next += 2;
    if (next == 0) return curve[1];
    if (next >= curve.size()) return curve.back();
    const auto inverse = [](double d) { return 1 / (d + kSharpOffset); };
    const double share = (inverse(distance) - inverse(curve[next - 2])) / (inverse(curve[next]) - inverse(curve[next - 2]));
    return curve[next - 1] + share * (curve[next + 1] - curve[next - 1]);
}

} // namespace trundle
