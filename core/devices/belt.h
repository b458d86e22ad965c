#pragma once
#include <string>
#include <vector>

#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// A geom whose surface runs: friction carries along what touches it. Its speed follows the command with at most MaxAcceleration.
class RunningSurface : public Device {
protected:
    template <class T> static void describeRunning(Describe<T>& d) {
        d.field("MaxSpeed", &RunningSurface::m_maxSpeed, metresPerSecond().within(1e-6, 1e3).required().live(),
                "Of its surface.");
        d.field("MaxAcceleration", &RunningSurface::m_maxAcceleration, metresPerSecondSquared().within(0, 1e6).live(),
                "Ramps of its speed; 0: no limit.");
        d.field("Power", &RunningSurface::m_power, unitOf("W").within(0, 1e6).live(),
                "That it draws from the robot's Battery at MaxSpeed, if it has one.");
    }
    /// Speed of the surface in this tick, m/s, on the way to the commanded one.
    [[nodiscard]] double next(Actuation& world, double commanded);
    /// To be called in sense: the way of the surface since the start, m.
    [[nodiscard]] double travelled(Sensing& world);
    [[nodiscard]] double runs() const { return m_rate; } ///< m/s

private:
    double m_maxSpeed = 0, m_maxAcceleration = 0, m_power = 0; ///< m/s, m/s^2, W
    double m_rate = 0, m_travel = 0;                           ///< m/s, m
};

/// A conveyor belt: a geom of a body or of scenery whose surface runs along its x axis, or turned from it by Heading about its z axis.
class Belt final : public RunningSurface, public BeltSignals {
public:
    static void describe(Describe<Belt>& d);
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    std::string m_geomName;
    double m_heading = 0; ///< rad
    GeomId m_geom;
};

/// The track of a tracked vehicle: geoms that rest on the ground and drive by running backwards below. Each one's x axis points forwards
/// and its z axis up.
class Track final : public RunningSurface, public TrackSignals {
public:
    static void describe(Describe<Track>& d);
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    std::vector<std::string> m_geomNames;
    std::vector<GeomId> m_geoms;
};

} // namespace trundle
