#pragma once
#include <string>
#include <vector>

#include <trundle/abi.h>

#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

/// Copies of the kinds of a module's descriptor, after the mark, the versions and every table in it have been checked. `library` is
/// named in messages and becomes Kind::module. Fields common to all controllers are not among them: see addControllerFields.
[[nodiscard]] Result<std::vector<Kind>> kindsOfModule(const TrundleModule* module, const std::string& library);

/// Why a module's kind cannot be used (a name that is no name, a range that is none ...); empty where it can.
[[nodiscard]] std::string kindFault(const Kind& kind);

/// Adds what every controller block has: UpdatePeriod, Isolation, Budget. Other kinds are left alone.
void addControllerFields(Kind& kind);

/// The values of those fields in a robot's controller block.
struct ControllerSettings {
    double updatePeriod = 0; ///< s; 0: every tick
    std::string isolation;   ///< empty: as the experiment says
    double budget = 0;       ///< s; 0: none
};
struct ComponentSpec;
[[nodiscard]] ControllerSettings controllerSettings(const ComponentSpec& controller);

} // namespace trundle
