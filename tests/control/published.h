#pragma once
// Not in the test files, because moc takes the member `signals` for its keyword.

#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// Adds a controller of this kind to a robot and its published signals to the layout, as the world does.
inline void addPublished(const Kind& kind, RobotSpec& robot, SignalLayout& layout) {
    robot.controllers.at(0).published = kind.signals;
    for (const SignalDescription& s : kind.signals)
        layout.add(robot.controllers[0].name + "/" + s.name, s.unit, SignalType::Real, SignalDirection::Output, s.count);
}

} // namespace trundle
