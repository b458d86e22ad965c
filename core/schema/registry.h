#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

/// All kinds that a text may use, by name. Filled at start-up from model, devices, logs and modules; it owns copies, so nothing
/// in it points into a library.
class Registry {
public:
    /// Fails if a kind with that name already exists; the message names both modules.
    [[nodiscard]] Status add(Kind kind);
    [[nodiscard]] const Kind* find(std::string_view name) const;
    /// In alphabetical order.
    [[nodiscard]] std::vector<const Kind*> all() const;
    /// Kinds allowed inside `parent` ("" is the top level).
    [[nodiscard]] std::vector<const Kind*> inside(std::string_view parent) const;

private:
    std::map<std::string, Kind, std::less<>> m_kinds;
};

} // namespace trundle
