#pragma once
// The single checks. Private to core/check.

#include <stop_token>

#include "base/diagnostic.h"
#include "check/start_scene.h"
#include "project/project.h"

namespace trundle {

void checkMasses(const ExperimentSpec& experiment, Diagnostics& diagnostics);
void checkDrives(const Loaded& loaded, Diagnostics& diagnostics);
/// What starts inside something else or below a floor.
void checkStart(const Loaded& loaded, const StartScene& scene, Diagnostics& diagnostics);
/// What starts in the air.
void checkSupport(const Loaded& loaded, const StartScene& scene, Diagnostics& diagnostics, const std::stop_token& stop);

/// "3.5 m", "12 mm": a length (m) in three digits.
[[nodiscard]] std::string lengthText(double metres);
/// Three digits.
[[nodiscard]] std::string figureText(double value);

} // namespace trundle
