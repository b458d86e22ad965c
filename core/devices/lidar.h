#pragma once
#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// Distances along beams that spread from one point: from -FieldOfView/2 to FieldOfView/2 counter-clockwise about its z axis,
/// both ends included; at 360 degrees the last beam is one step before the first, so that none is doubled. One beam or layer
/// alone is in the middle. Its own robot is not hit. With a SweepTime it turns: each tick casts the beams that it has passed, from where it
/// is then, and a reading is what was cast in the SweepTime before it. Intensity is that of a matt surface: its reflectance times the cosine
/// of the angle at which the beam meets it (Lambert's law; the loss by distance is taken to be compensated, as real lidars do).
class Lidar final : public Sensor, public LidarSignals, public RangeNoise {
public:
    Lidar();
    static void describe(Describe<Lidar>& d);

private:
    void begin(Mount& mount) override;
    void follow(Sensing& world) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;

    int m_beams = 360, m_layers = 1;
    double m_fieldOfView, m_verticalFieldOfView;  ///< rad
    double m_minRange = 0.05, m_maxRange = 10;    ///< m
    double m_sweepTime = 0, m_intensityNoise = 0; ///< s, -
    bool m_hasIntensity = false, m_hasObjects = false;

    void castPassed(Sensing& world);
    void cast(Sensing& world, std::uint32_t first, std::uint32_t end);

    Fan m_fan;
    Fan m_part;               ///< the bearings of it that a tick casts
    std::uint32_t m_cast = 0; ///< bearings of the reading that are cast
    std::vector<double> m_distances, m_partDistances, m_intensity, m_object;
    std::vector<GeomId> m_geoms;
    std::vector<Vec3> m_normals;
};

} // namespace trundle
