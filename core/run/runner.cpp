#include "run/runner.h"

#include "run/experiment_runner.h"
#include "run/log_kinds.h"

namespace trundle {

std::unique_ptr<Runner> Runner::create(std::shared_ptr<const ExperimentSpec> experiment, const DeviceCode& devices,
                                       const BackendFactory& backends, RunOptions options, Diagnostics& diagnostics) {
    const std::size_t errorsBefore = diagnostics.errorCount();
    checkLogs(*experiment, diagnostics);
    if (diagnostics.errorCount() > errorsBefore) return nullptr;
    if (!options.calls) options.calls = std::make_shared<CallMonitor>();
    std::unique_ptr<World> world = World::build(std::move(experiment), devices, diagnostics, options.calls);
    if (!world || diagnostics.errorCount() > errorsBefore) return nullptr;

    auto runner = std::make_unique<ExperimentRunner>(std::move(world), std::move(options));
    runner->startControllers(backends, diagnostics);
    if (diagnostics.errorCount() == errorsBefore) runner->openLogs(diagnostics);
    if (diagnostics.errorCount() > errorsBefore) return nullptr;
    return runner;
}

} // namespace trundle
