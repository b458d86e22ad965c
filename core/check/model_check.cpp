#include "check/model_check.h"

#include <cmath>
#include <cstdio>

#include "check/checks.h"
#include "world/validate.h"

namespace trundle {

std::string figureText(double value) {
    char text[32];
    const bool large = std::abs(value) >= 1000 && std::abs(value) < 1e9; // 2500, not 2.5e+03
    std::snprintf(text, sizeof text, large ? "%.0f" : "%.3g", value);
    return text;
}

std::string lengthText(double metres) {
    return std::abs(metres) < 1 ? figureText(1e3 * metres) + " mm" : figureText(metres) + " m";
}

void checkModel(const LoadedProject& loaded, Diagnostics& diagnostics, const std::stop_token& stop) {
    if (loaded.diagnostics.hasErrors() || loaded.pending) return;
    const ExperimentSpec& experiment = *loaded.experiment;
    Diagnostics silent;
    if (!isBuildable(experiment, silent)) return; // a run reports the reason
    checkUnused(loaded, diagnostics);
    checkBodies(loaded, diagnostics);
    checkMasses(experiment, diagnostics);
    checkLinks(experiment, diagnostics);
    checkDrives(loaded, diagnostics);
    checkNeeds(loaded, diagnostics);
    checkSprings(experiment, diagnostics);
    if (experiment.robots.empty() || stop.stop_requested()) return;
    const std::optional<StartScene> scene = StartScene::build(experiment, stop);
    if (!scene) return; // the same
    checkStart(loaded, *scene, diagnostics);
    checkSpeeds(loaded, *scene, diagnostics);
    checkSupport(loaded, *scene, diagnostics, stop);
}

} // namespace trundle
