#pragma once
// Apart from the tests: moc takes the member `signals` for its own word.

#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// Gives a robot with a controller of this kind the signals that it publishes, as a world lays them out.
inline void addPublished(const Kind& kind, RobotSpec& robot, SignalLayout& layout) {
    robot.published = kind.signals;
    for (const SignalDescription& s : kind.signals)
        layout.add(robot.name + "/" + robot.controller->name + "/" + s.name, s.unit, SignalType::Real, SignalDirection::Output, s.count);
}

} // namespace trundle
