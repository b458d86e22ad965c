#pragma once
#include <optional>

#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// Distance of what is in front of it: an infrared sensor along its x axis, an ultrasonic one in a cone about it. Rays on rings
/// fill the cone up to its edge; the nearest echo counts. An ultrasonic echo is lost if its surface is hit too obliquely or from
/// nearer than MinRange. Its own robot is not seen.
class RangeSensor final : public Sensor, public RangeSensorSignals, public RangeNoise {
public:
    RangeSensor();
    static void describe(Describe<RangeSensor>& d);

private:
    void begin(Mount& mount) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;
    [[nodiscard]] double voltageAt(double range) const;

    std::string m_type = "infrared";
    double m_minRange = 0.02, m_maxRange = 2, m_maxIncidence; ///< m, m, rad
    std::optional<double> m_coneAngle;                        ///< rad
    std::vector<double> m_voltageCurve;                       ///< distance (m), voltage (V) ...

    bool m_isUltrasonic = false;
    std::vector<Vec3> m_directions; ///< of its rays, in its own frame
    std::vector<Ray> m_rays;        ///< the same in the world
    std::vector<double> m_distances;
    std::vector<Vec3> m_normals;
    std::vector<GeomId> m_geoms;
};

/// Unit vectors in a cone about x, evenly in rings from the axis to the edge; one for a cone without width. `coneAngle` is the
/// full angle, rad.
[[nodiscard]] std::vector<Vec3> directionsInCone(double coneAngle);

} // namespace trundle
