#pragma once
// The description file of a module, `<library>.kinds.json`: its kinds, readable without running its code.

#include <memory>
#include <string>
#include <vector>

#include "base/call_monitor.h"
#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

/// "d/libn.so" → "d/libn.so.kinds.json".
[[nodiscard]] std::string kindsJsonPath(const std::string& library);

[[nodiscard]] std::string kindsToJson(const std::vector<Kind>& kinds);
/// Fails with E408 and the position if a text is not a valid description.
[[nodiscard]] Result<std::vector<Kind>> kindsFromJson(const std::string& text, const std::string& library);

/// Loads `library` (its code runs) and writes its description to `out`. Used by `trundle-cli describe --module`.
[[nodiscard]] Status writeKindsJson(const std::string& library, const std::string& out,
                                    std::shared_ptr<CallMonitor> calls = std::make_shared<CallMonitor>());

} // namespace trundle
