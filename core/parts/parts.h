#pragma once
// The parts of the house, built once by main and joined: each command takes what it needs.

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "parts/locations.h"
#include "parts/open_options.h"
#include "project/project.h"
#include "run/runner.h"

namespace trundle {

class Parts {
public:
    virtual ~Parts() = default;

    /// Kinds of model, devices and logs.
    [[nodiscard]] virtual std::shared_ptr<const Registry> builtIn() const = 0;
    /// Kinds that the modules in the program's and in the given folders say they bring. Runs no code of theirs.
    [[nodiscard]] virtual std::vector<Kind> moduleKinds(const OpenOptions& options) const = 0;
    /// Where the program's own files are.
    [[nodiscard]] virtual const Locations& locations() const = 0;
    /// Reads an experiment and all it imports. May be called from several threads at once. Fails only where the file itself cannot be read.
    [[nodiscard]] virtual Result<std::shared_ptr<const Loaded>> open(const std::string& path, const OpenOptions& options) = 0;
    /// World, controllers and logs of an opened experiment. nullptr with diagnostics where they cannot be had. The runner must go
    /// before the parts.
    [[nodiscard]] virtual std::unique_ptr<Runner> makeRunner(const Loaded& loaded, RunOptions options,
                                                             Diagnostics& diagnostics) = 0;
};

[[nodiscard]] std::unique_ptr<Parts> makeParts();

} // namespace trundle
