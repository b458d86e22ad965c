#pragma once
// What is wrong with an experiment although its text makes sense: found before a run, so that the run need not show it.

#include <stop_token>

#include "base/diagnostic.h"
#include "project/project.h"

namespace trundle {

/// Things that start inside others, below the floor or in the air, joined bodies of very different mass, drives that disagree with
/// their wheels. Says object, reason and, where one is obvious, the edit that corrects it. Nothing where the load has errors or waits
/// for a mesh. Runs no code of modules; may be called in any thread. Returns soon after a stop is requested, with what it found so far.
void checkModel(const Loaded& loaded, Diagnostics& diagnostics, const std::stop_token& stop = {});

} // namespace trundle
