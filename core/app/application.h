#pragma once
// The composition root, built once by main: all commands of the programs use it.

#include <memory>
#include <string>
#include <vector>

#include "app/locations.h"
#include "app/open_options.h"
#include "base/result.h"
#include "control/isolation.h"
#include "project/loading/project.h"
#include "run/runner.h"

namespace trundle {

class Application {
public:
    virtual ~Application() = default;

    /// The built-in kinds of model, devices and logs.
    [[nodiscard]] virtual std::shared_ptr<const Registry> builtIn() const = 0;
    /// Kinds declared by the manifests of the modules in the program's and the given folders. Runs no code of libraries; Python files of the
    /// given folders are loaded in another process if they changed.
    [[nodiscard]] virtual std::vector<Kind> moduleKinds(const OpenOptions& options) const = 0;
    /// Why modules of these folders have no kinds there: descriptions that cannot be read, Python files that cannot be loaded.
    [[nodiscard]] virtual std::vector<Error> moduleFaults(const OpenOptions&) const { return {}; }
    /// Which controllers have a process of their own where the experiment does not say it.
    [[nodiscard]] virtual Isolation isolation() const { return Isolation::None; }
    /// Paths of the program's own files.
    [[nodiscard]] virtual const Locations& locations() const = 0;
    /// Loads an experiment and everything it imports. Thread-safe. Fails only if the experiment file itself cannot be read.
    [[nodiscard]] virtual Result<std::shared_ptr<const LoadedProject>> open(const std::string& path,
                                                                            const OpenOptions& options) = 0;
    /// Builds the world, controllers and logs of a loaded experiment. Returns nullptr and adds diagnostics on failure. The runner
    /// must be destroyed before the application.
    [[nodiscard]] virtual std::unique_ptr<Runner> makeRunner(const LoadedProject& loaded, RunOptions options,
                                                             Diagnostics& diagnostics) = 0;
};

/// `isolation` holds for controllers for which the experiment does not set it.
[[nodiscard]] std::unique_ptr<Application> makeApplication(Locations locations = findLocations(),
                                                           Isolation isolation = Isolation::None);

} // namespace trundle
