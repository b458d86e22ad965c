#pragma once
#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// Distances along beams that spread from one point: from -FieldOfView/2 to FieldOfView/2 counter-clockwise about its z axis,
/// both ends included; at 360 degrees the last beam is one step before the first, so that none is doubled. One beam or layer
/// alone is in the middle. Its own robot is not hit.
class Lidar final : public Sensor, public LidarSignals, public RangeNoise {
public:
    Lidar();
    static void describe(Describe<Lidar>& d);

private:
    void begin(Mount& mount) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;

    int m_beams = 360, m_layers = 1;
    double m_fieldOfView, m_verticalFieldOfView; ///< rad
    double m_minRange = 0.05, m_maxRange = 10;   ///< m

    Fan m_fan;
};

} // namespace trundle
