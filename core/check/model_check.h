#pragma once
// Finds faults of an experiment that is valid as text, before it is run.

#include <stop_token>

#include "base/diagnostic.h"
#include "project/loading/project.h"

namespace trundle {

/// Reports robots that start inside something, below the floor, in the air or without any scenery, gravity out of the floor, bodies that
/// no joint holds or that are in the place of another one, double joints, loops, odd mass properties, joined bodies of very different
/// mass, drives that disagree with their wheels, jaws that do not close, robots without what their controller needs, wheels and tracks off
/// the ground, motors too weak for a ramp or oddly fast, scenery too thin for the tick, springs too fast for it or without damping, and
/// unused definitions, with a fix where one is obvious. Reports nothing if the project has errors or waits for a mesh. Runs no module code.
/// Thread-safe. Returns soon after a stop request, with the findings so far. `definitions`: the file of which unused ones are reported; past the
/// last file: none.
void checkModel(const LoadedProject& loaded, Diagnostics& diagnostics, const std::stop_token& stop = {}, FileId definitions = 0);

/// Tries each RobotConfig with motors, alone on a plain floor without its controllers, in the physics engine, and reports those that fall
/// over, lean, stand on the stops of their springs, cannot hold their servos, or whose drives move them otherwise than commanded. Leaves
/// out configs for which `diagnostics` has a warning, as that names the cause, and those with devices of modules, of whose code nothing
/// is run. Takes milliseconds for most robots; two seconds and 30 robots at most. Thread-safe. Returns soon after a stop request.
void tryRobots(const LoadedProject& loaded, Diagnostics& diagnostics, const std::stop_token& stop = {});

} // namespace trundle
