#pragma once
#include <optional>

namespace trundle {

/// The driver of a motor: what becomes of its command.
struct MotorDriver {
    std::optional<double> currentLimit; ///< A
    double deadBand = 0;                ///< V
    int pwmSteps = 0;                   ///< 0: continuous

    /// The voltage of a command (V), where full duty is `full`.
    [[nodiscard]] double voltageOf(double command, double full) const;
};

} // namespace trundle
