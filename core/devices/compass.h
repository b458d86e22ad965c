#pragma once
#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// The heading of its x axis over the floor, counter-clockwise from the x axis of the world; of an axis that points straight up
/// or down, 0.
class Compass final : public Sensor, public CompassSignals {
public:
    static void describe(Describe<Compass>& d);

private:
    void begin(Mount& mount) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;

    double m_noise = 0, m_bias = 0, m_resolution = 0; ///< rad
};

} // namespace trundle
