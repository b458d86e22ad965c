#pragma once
#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// Position and velocity of its antenna in the world. The error of the position fades within CorrelationTime, as that of a real
/// receiver does: a first-order Gauss-Markov process (Brown, Hwang: Introduction to Random Signals, 3rd ed., sec. 2.9).
class Gps final : public Sensor, public GpsSignals {
public:
    static void describe(Describe<Gps>& d);

private:
    void begin(Mount& mount) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;
    void moveError(const Services& world);

    std::vector<double> m_noise{0};                                      ///< m
    double m_velocityNoise = 0, m_correlationTime = 0, m_resolution = 0; ///< m/s, s, m
    double m_dropouts = 0, m_minSky = 0;
    [[nodiscard]] bool seesSky(Sensing& world, const Vec3& antenna) const;

    bool m_hasError = false; ///< drawn once
    Vec3 m_error = Vec3::Zero();
};

} // namespace trundle
