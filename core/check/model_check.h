#pragma once
// Finds faults of an experiment that is valid as text, before it is run.

#include <stop_token>

#include "base/diagnostic.h"
#include "project/loading/project.h"

namespace trundle {

/// Reports robots that start inside something, below the floor, in the air or without any scenery, joined bodies of very different mass, drives
/// that disagree with their wheels, and springs too fast for the tick, with a fix where one is obvious. Reports nothing if the project has errors or waits for a
/// mesh. Runs no module code. Thread-safe. Returns soon after a stop request, with the findings so far.
void checkModel(const LoadedProject& loaded, Diagnostics& diagnostics, const std::stop_token& stop = {});

} // namespace trundle
