#pragma once
// Compares how far robots with a DifferentialDrive moved with how far they were commanded to move.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "world/world.h"

namespace trundle {

/// In metres and radians, positive forward and left.
struct DriveTotals {
    std::size_t robot = 0; ///< index into the experiment's robots
    double commandedDistance = 0, commandedAngle = 0;
    double drivenDistance = 0, drivenAngle = 0;
    /// Error of the finished amounts only.
    double distanceError = 0, angleError = 0;
    std::size_t ended = 0; ///< number of finished amounts
    bool underWay = false; ///< the last amount has not finished
    bool freely = false;   ///< it sometimes drove at a speed without an amount, so there is no commanded sum to compare with
};

/// Tracks the true pose of each drive's axle centre from tick to tick. Only reads signals.
class DriveStatistics {
public:
    /// Finds the drives of all robots: components with the signals of a DifferentialDrive.
    explicit DriveStatistics(const World& world);
    void afterTick(const World& world);
    /// Only drives that were commanded amounts, and no free motion.
    [[nodiscard]] std::vector<DriveTotals> totals() const;

private:
    struct Drive {
        DriveTotals totals;
        std::array<std::uint32_t, 4> commands{};            // slots of linear and angular velocity, linear and angular amount
        std::uint32_t pose = 0, sequence = 0, done = 0;     // slots
        double x = 0, y = 0, heading = 0, lastSequence = 0; // at the last tick
        double amountDistance = 0, amountAngle = 0;         // commanded, of the current amount
        double drivenBefore = 0, turnedBefore = 0;          // totals when it began
        bool commanded = false, running = false;
    };
    static void addCommand(Drive& drive, std::span<const double> slots);
    static void endAmount(Drive& drive);

    std::vector<Drive> m_drives;
};

} // namespace trundle
