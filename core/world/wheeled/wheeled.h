#pragma once
// The wheeled engine from outside: whether it can hold an experiment, and the engine. Engine = planar is the same engine with vehicles
// that keep their height, do not lean and put the weight on their wheels that they do at rest.

#include <memory>
#include <optional>
#include <string>

#include "base/diagnostic.h"
#include "world/engine.h"

namespace trundle {

/// True if all of it can. Else an error for each kind of thing that cannot, at its place.
[[nodiscard]] bool fitsWheeled(const ExperimentSpec& experiment, Diagnostics& out);
/// The first of these; empty if all of it can.
[[nodiscard]] std::string whyNotWheeled(const ExperimentSpec& experiment);

/// Height of the ground that carries an experiment's robots, m.
[[nodiscard]] std::optional<double> wheeledGround(const ExperimentSpec& experiment);

/// On the ground at that height, or else on that below its first actor. An actor that it cannot hold is an error, NotInEngine.
[[nodiscard]] Result<std::unique_ptr<Engine>> makeWheeledEngine(const EngineSettings& settings, bool planar,
                                                                std::optional<double> ground = {});

} // namespace trundle
