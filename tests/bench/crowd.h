#pragma once
// What the loops on bare engines share, so that each has the crowd that Trundle has: N shipped robots (configs/robots/simple_robot.sim) in
// a walled room, their random commands and the options of the programs. Random numbers and ramps are Trundle's, with the same seed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/rng.h"

namespace crowd {

// The robot, in metres and kilograms; positions in the config frame, whose origin lies on the floor.
inline constexpr double kAxleX = 0.06, kTrack = 0.25, kWheelRadius = 0.05, kWheelWidth = 0.03, kWheelMass = 0.15;
inline constexpr double kHullMass = 2.0, kSliderMass = 0.05, kBumperMass = 0.05, kSliderRadius = 0.02;
inline constexpr std::array<double, 3> kHullSize{0.30, 0.20, 0.10}, kHullAt{0, 0, 0.09};
inline constexpr std::array<double, 3> kBumperSize{0.02, 0.30, 0.04}, kBumperAt{0.16, 0, 0.07};
inline constexpr std::array<double, 3> kSliderAt{-0.12, 0, 0.02};
inline constexpr double kReach = 0.235; // distance from the centre of the chassis to its farthest corner, tyres included
inline constexpr double kServoTorque = 3.6, kPlasticFriction = 0.2, kTyreFriction = 1.0;

// Commands: RandomDrive with its defaults, limited by the ramps of the drive.
inline constexpr double kSpeed = 0.3, kTurnRate = 1.0, kPeriod = 1.0, kAcceleration = 1.0, kTurnAcceleration = 4.0;
inline constexpr std::uint64_t kSeed = 1;

/// The commands of one robot: new ones at random each period, approached along ramps.
class Drive {
public:
    explicit Drive(std::size_t index) : m_pathHash(trundle::fnv1a64("crowd_" + std::to_string(index))) {}

    /// Once per tick, before it.
    void think(long ticks, double tick) {
        if (static_cast<double>(ticks) * tick >= m_changes * kPeriod) {
            ++m_changes;
            m_aimSpeed = kSpeed * draw(ticks, 0, -0.25, 1);
            m_aimTurn = kTurnRate * draw(ticks, 1, -1, 1);
        }
        const double speedUp = m_aimSpeed - m_speed, turnUp = m_aimTurn - m_turn; // both reach their targets at the same time
        const double time = std::max(std::fabs(speedUp) / kAcceleration, std::fabs(turnUp) / kTurnAcceleration);
        const double part = time <= tick ? 1 : tick / time;
        m_speed += part * speedUp;
        m_turn += part * turnUp;
    }
    /// rad/s, left and right
    [[nodiscard]] std::array<double, 2> wheelRates() const {
        return {(m_speed - m_turn * kTrack / 2) / kWheelRadius, (m_speed + m_turn * kTrack / 2) / kWheelRadius};
    }

private:
    [[nodiscard]] double draw(long ticks, std::uint64_t index, double low, double high) const {
        return low +
               (high - low) * trundle::toUnit(trundle::randomBits(kSeed, m_pathHash, static_cast<std::uint64_t>(ticks), index));
    }

    std::uint64_t m_pathHash; // seed of the robot's random numbers
    double m_aimSpeed = 0, m_aimTurn = 0, m_speed = 0, m_turn = 0, m_changes = 0;
};

struct Options {
    int count = 100, columns = 0, rows = 0;
    double seconds = 20, tick = 0.01;
};

/// Half the inner size of the room, along x or y, m: at least one robot per square metre.
inline double halfRoom(int robots) { return std::max(robots, 4) / 2.0; }
/// Where a robot starts, m: its config frame.
inline std::array<double, 2> startOf(int index, const Options& options) {
    return {index % options.columns - (options.columns - 1) / 2.0, index / options.columns - (options.rows - 1) / 2.0};
}

/// Of the process so far, kB.
inline long peakKb() {
    std::FILE* file = std::fopen("/proc/self/status", "r");
    char line[256];
    long kb = 0;
    while (file != nullptr && std::fgets(line, sizeof line, file) != nullptr) (void)std::sscanf(line, "VmHWM: %ld", &kb);
    if (file != nullptr) std::fclose(file);
    return kb;
}

inline Options parse(const char* program, int argc, char** argv) {
    Options options;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string key = argv[i];
        const double value = std::atof(argv[i + 1]);
        if (key == "-n") options.count = static_cast<int>(value);
        else if (key == "-nx") options.columns = static_cast<int>(value);
        else if (key == "-ny") options.rows = static_cast<int>(value);
        else if (key == "-t") options.seconds = value;
        else if (key == "-h") options.tick = value;
        else {
            std::fprintf(stderr, "%s: what is %s?\n", program, key.c_str());
            std::exit(2);
        }
    }
    if (options.columns <= 0) options.columns = static_cast<int>(std::ceil(std::sqrt(options.count)));
    if (options.rows <= 0) options.rows = (options.count + options.columns - 1) / options.columns;
    return options;
}

} // namespace crowd
