// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// What all sensors have in common: where they are, when they measure, when the reading appears, and how it errs. The same names
// mean the same in every sensor that uses this header. Since 1.6.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <trundle/device.h>
#include <trundle/normal_deviate.h>

namespace trundle {
inline namespace sdk1 {

/// Times k * period, k = 0, 1, 2 ..., without drift: each is due at the first tick at or after it, and one tick serves all that
/// are due.
class SensorClock {
public:
    /// True if a time is due at `now` (s); then the following one is awaited. A period of 0 is due at every tick.
    [[nodiscard]] bool due(double now, double period, double tick) {
        if (!(period > 0)) return true;
        const double slack = 1e-6 * tick;
        if (now + slack < m_count * period) return false;
        m_count = std::max(m_count + 1, std::floor((now + slack) / period) + 1);
        return true;
    }

private:
    double m_count = 0; ///< number of the next time
};

/// The multiple of `step` that is nearest to a value; with a step of 0 the value itself.
[[nodiscard]] inline double roundedTo(double value, double step) {
    const double steps = step > 0 ? value / step : 0;
    return step > 0 && std::abs(steps) < 0x1p52 ? std::nearbyint(steps) * step : value;
}

/// The multiple of `step` from `least` to `most` that is nearest to a value; with a step of 0 the value itself, at least `least` and at
/// most `most`. Where no multiple is between them, the nearer of the two. Since 1.7.
[[nodiscard]] inline double roundedWithin(double value, double least, double most, double step) {
    const double near = roundedTo(std::clamp(value, least, most), step);
    const double slack = 1e-9 * step;
    if (near > most + slack && near - step >= least - slack) return near - step;
    if (near < least - slack && near + step <= most + slack) return near + step;
    return std::clamp(near, least, most);
}

/// A sensor fixed to a body. It measures when UpdatePeriod says, and what it measured is published Latency later. A kind derives
/// from it, calls describeSensor() in its describe(), and overrides begin, measure and publish.
class Sensor : public Device {
public:
    void setup(Mount& mount) final {
        m_body = mount.body(m_bodyName);
        m_mounting = {Vec3(m_position.data()), rotationFromHpr(Vec3(m_hpr.data()))};
        begin(mount);
    }
    void sense(Sensing& world) final {
        follow(world);
        if (!world.supply().powered()) return; // it has no new readings
        if (m_power > 0) world.draw(m_power);
        if (m_clock.due(world.time(), m_updatePeriod, world.tick())) take(world);
        const double now = world.time() + 1e-6 * world.tick();
        while (!m_waiting.empty() && m_waiting.front().time + m_latency <= now) {
            publish(m_waiting.front().values, m_waiting.front().time);
            m_spare = std::move(m_waiting.front().values);
            m_waiting.pop_front();
        }
    }

protected:
    /// Describes Body, Pos, HPR, UpdatePeriod, Latency and, since 1.8, Power.
    template <class T> static void describeSensor(Describe<T>& d) {
        d.field("Body", &Sensor::m_bodyName, reference("Body").required(), "The body it is fixed to.");
        d.field("Pos", &Sensor::m_position, metres().within(-1e5, 1e5), "Its position in the body.");
        d.field("HPR", &Sensor::m_hpr, degrees().within(-1e6, 1e6),
                "Heading, pitch and roll in the body; 0,0,0 faces along x with z up.");
        d.field("UpdatePeriod", &Sensor::m_updatePeriod, seconds().within(0, 1e6), "Time between two readings; 0: every tick.");
        d.field("Latency", &Sensor::m_latency, seconds().within(0, 1), "Age of a reading when it is published.");
        d.field("Power", &Sensor::m_power, unitOf("W").within(0, 1e6), "That it draws from the robot's Battery, if it has one.");
    }

    virtual void begin(Mount&) {}
    /// Called in every tick, before measure; without power too, so that what it compares with the tick before is of that tick.
    virtual void follow(Sensing&) {}
    /// Fills `reading` with what it measures now; left empty, this reading is missed. Called only when a reading is due.
    virtual void measure(Sensing& world, std::vector<double>& reading) = 0;
    /// Sets the outputs from a reading that was measured at `time` (s).
    virtual void publish(std::span<const double> reading, double time) = 0;

    [[nodiscard]] BodyId body() const { return m_body; }
    [[nodiscard]] const Pose& mounting() const { return m_mounting; } ///< pose in the body
    /// Time from one reading to the next, s: UpdatePeriod, or the tick.
    [[nodiscard]] double interval(double tick) const { return std::max(m_updatePeriod, tick); }
    /// Pose of the sensor in the world after the last step.
    [[nodiscard]] Pose pose(const Services& world) const { return poseOf(world.bodyState(m_body)) * m_mounting; }
    [[nodiscard]] static Pose poseOf(const TrundleBodyState& body) {
        const double* q = body.quaternion;
        return {Vec3(body.position), Quat(q[0], q[1], q[2], q[3])};
    }

private:
    struct Reading {
        double time = 0;
        std::vector<double> values;
    };

    void take(Sensing& world) {
        m_spare.clear();
        measure(world, m_spare);
        if (m_spare.empty()) return;
        if (m_latency > 0) m_waiting.push_back({world.time(), std::exchange(m_spare, {})});
        else publish(m_spare, world.time());
    }

    std::string m_bodyName;
    std::array<double, 3> m_position{0, 0, 0}, m_hpr{0, 0, 0};
    double m_updatePeriod = 0, m_latency = 0, m_power = 0;

    BodyId m_body;
    Pose m_mounting;
    SensorClock m_clock;
    std::deque<Reading> m_waiting; ///< until Latency has passed
    std::vector<double> m_spare;
};

/// How a measured distance errs: a base class of the sensor. Its random numbers depend on (seed, path, tick) and the number of
/// the reading in this tick alone.
struct RangeNoise {
    double deviation = 0, perMetre = 0, outliers = 0, dropouts = 0, resolution = 0;

    /// Describes Noise, NoisePerMetre, Outliers, Dropouts and Resolution.
    template <class T> static void describeNoise(Describe<T>& d) {
        d.field("Noise", &RangeNoise::deviation, metres().within(0, 1e3), "Standard deviation of a distance.");
        d.field("NoisePerMetre", &RangeNoise::perMetre, number().within(0, 10),
                "Grows the standard deviation for each metre of distance.");
        d.field("Outliers", &RangeNoise::outliers, number().within(0, 1),
                "Share of readings that are any distance from MinRange to MaxRange.");
        d.field("Dropouts", &RangeNoise::dropouts, number().within(0, 1),
                "Share of readings that miss what is there and are MaxRange.");
        d.field("Resolution", &RangeNoise::resolution, metres().within(0, 1e3), "Readings are multiples of it; 0: exact.");
    }

    /// What is read for a true distance: from `least` to `most`, which is also the distance where nothing is hit. `index` is the
    /// number of the reading in this tick.
    [[nodiscard]] double apply(double distance, double least, double most, const Services& world, std::uint64_t index) const {
        constexpr std::uint64_t kDraws = 3;
        if (outliers > 0 || dropouts > 0) {
            const double draw = world.random(kDraws * index);
            if (draw < dropouts) return most;
            if (draw < dropouts + outliers) distance = least + (most - least) * world.random(kDraws * index + 1);
            else distance = blurred(distance, most, world, kDraws * index + 2);
        } else {
            distance = blurred(distance, most, world, kDraws * index + 2);
        }
        return distance < most ? roundedWithin(distance, least, most, resolution) : most;
    }

private:
    /// Nothing hit stays nothing hit.
    [[nodiscard]] double blurred(double distance, double most, const Services& world, std::uint64_t index) const {
        const double sigma = deviation + perMetre * distance;
        return sigma > 0 && distance < most ? distance + sigma * normalDeviate(world.randomBits(index)) : distance;
    }
};

} // namespace sdk1
} // namespace trundle
