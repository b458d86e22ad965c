#pragma once
#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// Share of light that the floor below it returns: a mean over a round spot, straight along its -z. The floor is whatever collides
/// there, with the picture or colour of its material; a sensor's own lamp lights it, so that light and shadow do not matter. Its own
/// robot is not seen.
class GroundSensor final : public Sensor, public GroundSensorSignals {
public:
    static void describe(Describe<GroundSensor>& d);

private:
    void begin(Mount& mount) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;

    double m_maxHeight = 0.05, m_spot = 0; ///< m
    double m_noise = 0, m_resolution = 0;

    std::vector<Vec3> m_places; ///< of its rays, in its own frame
    std::vector<Ray> m_rays;    ///< the same in the world
    std::vector<double> m_distances;
    std::vector<GeomId> m_geoms;
    std::vector<Vec3> m_normals;
};

/// Points of a disc about the origin in the plane z = 0, each of which stands for an equal area; one for a disc without width.
[[nodiscard]] std::vector<Vec3> placesOnDisc(double diameter);

} // namespace trundle
