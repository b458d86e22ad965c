#pragma once
// How far robots with a drive really went, beside how far they were told to go.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "world/world.h"

namespace trundle {

/// Metres and radians, forward and left positive.
struct DriveTotals {
    std::size_t robot = 0; ///< index into the experiment's robots
    double commandedDistance = 0, commandedAngle = 0;
    double drivenDistance = 0, drivenAngle = 0;
    /// Of the amounts that ran to their end alone: how far they were off.
    double distanceError = 0, angleError = 0;
    std::size_t ended = 0; ///< how many those are
    bool underWay = false; ///< the last amount has not ended
    bool freely = false;   ///< at times it drove at a speed without an amount: there is no sum to compare with
};

/// Follows the true pose of each drive's axle middle from tick to tick. Reads signals only.
class DriveMeter {
public:
    /// Looks for the drives of all robots: components with the signals of a DifferentialDrive.
    explicit DriveMeter(const World& world);
    void afterTick(const World& world);
    /// Those that were told to go some way and drove by such amounts alone.
    [[nodiscard]] std::vector<DriveTotals> totals() const;

private:
    struct Drive {
        DriveTotals totals;
        std::array<std::uint32_t, 4> commands{};            // slots of linear and angular velocity, linear and angular amount
        std::uint32_t pose = 0, sequence = 0, done = 0;     // slots
        double x = 0, y = 0, heading = 0, lastSequence = 0; // of the last tick
        double amountDistance = 0, amountAngle = 0;         // of the amount that goes on: commanded
        double drivenBefore = 0, turnedBefore = 0;          // driven when it began
        bool commanded = false, running = false;
    };
    static void addCommand(Drive& drive, std::span<const double> slots);
    static void endAmount(Drive& drive);

    std::vector<Drive> m_drives;
};

} // namespace trundle
