#include "check/model_check.h"

#include <cmath>
#include <cstdio>
#include <set>
#include <tuple>

#include "check/checks.h"
#include "world/validate.h"

namespace trundle {

std::string figureText(double value) {
    char text[32];
    const bool large = std::abs(value) >= 999.5 && std::abs(value) < 1e9; // 2500, not 2.5e+03
    std::snprintf(text, sizeof text, large ? "%.0f" : "%.3g", value);
    return text;
}

std::string lengthText(double metres) {
    return std::abs(metres) < 0.9995 ? figureText(1e3 * metres) + " mm" : figureText(metres) + " m";
}

namespace {

/// Of what is found at one place, as in each member of a Repeat or of a Grid, only the first.
void appendFirsts(Diagnostics& diagnostics, const Diagnostics& found) {
    std::set<std::tuple<Code, FileId, std::uint32_t>> seen;
    std::vector<Diagnostic> firsts;
    for (const Diagnostic& d : found.all())
        if (seen.insert({d.code, d.range.file, d.range.range.begin}).second) firsts.push_back(d);
    diagnostics.append(std::move(firsts));
}

} // namespace

void checkModel(const LoadedProject& loaded, Diagnostics& diagnostics, const std::stop_token& stop, FileId definitions) {
    if (loaded.diagnostics.hasErrors() || loaded.pending) return;
    const ExperimentSpec& experiment = *loaded.experiment;
    Diagnostics silent;
    if (!isBuildable(experiment, silent)) return; // a run reports the reason
    checkUnused(loaded, definitions, diagnostics);
    Diagnostics ofConfigs;
    checkBodies(loaded, ofConfigs);
    checkGears(experiment, ofConfigs);
    checkMasses(experiment, ofConfigs);
    checkDrives(loaded, ofConfigs);
    checkSprings(experiment, ofConfigs);
    checkHolds(experiment, ofConfigs);
    appendFirsts(diagnostics, ofConfigs);
    checkLinks(experiment, diagnostics);
    checkNeeds(loaded, diagnostics);
    if (experiment.robots.empty() || reportedGravity(loaded, diagnostics) || stop.stop_requested()) return;
    const std::optional<StartScene> scene = StartScene::build(experiment, stop);
    if (!scene) return; // the same
    checkStart(loaded, *scene, diagnostics);
    checkSpeeds(loaded, scene->up(), diagnostics);
    checkGround(*scene, diagnostics);
    checkSupport(loaded, *scene, diagnostics, stop);
}

} // namespace trundle
