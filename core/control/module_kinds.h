#pragma once
#include <string>
#include <vector>

#include <trundle/abi.h>

#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

/// Checks the magic number, the versions and every table of a module's descriptor, and copies its kinds. `library` is named in
/// messages and becomes Kind::module. The fields common to all controllers are not included: see addControllerFields.
[[nodiscard]] Result<std::vector<Kind>> kindsOfModule(const TrundleModule* module, const std::string& library);

/// Why a module's kind cannot be used (an invalid name, an invalid range ...); empty if it can.
[[nodiscard]] std::string kindFault(const Kind& kind);

/// Adds the fields of every controller block: UpdatePeriod, Isolation, Budget. Other kinds are unchanged.
void addControllerFields(Kind& kind);

} // namespace trundle
