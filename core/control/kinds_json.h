#pragma once
// The description file of a module, `<library>.kinds.json`: what its kinds are, for those who must not run its code.

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
/// Fails with E408 and the place where a text is not such a description.
[[nodiscard]] Result<std::vector<Kind>> kindsFromJson(const std::string& text, const std::string& library);

/// Loads `library` (its code runs) and writes its description to `out`. What `trundle-cli describe --module` does.
[[nodiscard]] Status writeKindsJson(const std::string& library, const std::string& out,
                                    std::shared_ptr<CallMonitor> calls = std::make_shared<CallMonitor>());

} // namespace trundle
