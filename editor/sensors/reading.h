#pragma once
// A quantity of a device that the Sensors dock shows: where it is in the signals, its limits and its true value.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "run/live/live_state.h"

namespace trundle {

/// The largest number of numbers that a reading shows; a signal with more is shown as its least and greatest.
inline constexpr std::size_t kMaxShownNumbers = 4;

/// One quantity: a signal, or a part of one with several quantities.
struct Reading {
    using Read = std::function<void(const LiveSnapshot&, double* numbers)>;

    std::string name;   ///< "range", "pose x, y"
    std::string signal; ///< "robot0/front/range"
    std::string unit;   ///< SI
    std::string help;   ///< a sentence, or empty
    SignalType type = SignalType::Real;
    bool commanded = false;                          ///< set by a controller, not measured
    bool isAngle = false;                            ///< between -pi and pi: a jump from one to the other is no change
    std::size_t count = 1;                           ///< numbers, at most kMaxShownNumbers
    Read read;                                       ///< writes `count` numbers
    Read readTrue;                                   ///< the same without errors; empty if there is no such value
    std::shared_ptr<const std::vector<std::string>> names; ///< it is the number of one of these, an empty one is nothing; null: a quantity
    std::optional<std::pair<double, double>> limits; ///< of the quantity, in SI; none: unknown
};

} // namespace trundle
