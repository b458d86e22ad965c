#include "run/command_signals.h"

#include <algorithm>
#include <cmath>

namespace trundle {

Status setSignal(World& world, const SignalCommand& signal) {
    const auto entry = world.layout().find(signal.path);
    if (!entry) return Error{Code::NoSuchPath, "there is no signal " + signal.path};
    if (entry->direction != SignalDirection::Command || signal.element >= entry->count)
        return Error{Code::WrongPlace, signal.path + " is no command"};
    if (!std::isfinite(signal.value)) return Error{Code::OutOfRange, "the value for " + signal.path + " is not a finite number"};
    world.block().slots()[entry->offset + signal.element] = signal.value;
    return {};
}

void setCommandsToZero(World& world, const RobotSpec& robot) {
    for (const SignalEntry& entry : world.layout().entriesOf(robot.name))
        if (entry.direction == SignalDirection::Command)
            std::fill_n(world.block().slots().begin() + entry.offset, entry.count, 0.0);
}

} // namespace trundle
