#pragma once
#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// Illuminance of a small surface that faces along its x: of the experiment's sun, lamps and sky, each as cameras see it, and of
/// Leds. What collides blocks the sun, the Leds and the lamps that cast shadows, except its own robot.
class LightSensor final : public Sensor, public LightSensorSignals {
public:
    static void describe(Describe<LightSensor>& d);

private:
    void begin(Mount& mount) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;
    [[nodiscard]] double response(double cosine) const;
    [[nodiscard]] double shareFromAbove(double up) const;

    double m_exponent = 1;
    double m_maxIlluminance = 1e5, m_noise = 0, m_noiseShare = 0, m_resolution = 0; ///< lx, lx, 1, lx

    std::vector<TrundleLight> m_lights;
    std::vector<TrundleBeam> m_beams; ///< of them
    std::vector<Ray> m_rays;          ///< towards those that cast shadows
    std::vector<double> m_shares, m_distances;
    std::vector<double> m_cotangents; ///< of the angles from its axis of equal parts of what it sees; none: a flat surface
};

} // namespace trundle
