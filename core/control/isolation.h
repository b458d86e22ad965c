#pragma once
#include "model/experiment_spec.h"

namespace trundle {

/// Which controllers share a process: none has one (all run inside the program), those of a module, only that of one robot.
enum class Isolation { None, Module, Robot };

/// Of a controller: as its block says, else as the experiment says, else `otherwise`.
[[nodiscard]] Isolation isolationOf(const ComponentSpec& controller, const SettingsSpec& settings, Isolation otherwise);

} // namespace trundle
