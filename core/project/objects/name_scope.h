#pragma once
// Items of a block with imports expanded in place, and the Params in scope. Private to core/project.

#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "model/outline.h"

namespace trundle {

/// Calls `take` for every directive, assignment, Param and block of `items`; imported files are expanded in place, each once.
void eachItem(const TextSet& texts, const std::vector<Item>& items, FileId file,
              const std::function<void(const Item& item, FileId file)>& take);

/// The Params declared in one block and its enclosing scopes.
class NameScope {
public:
    NameScope() = default;
    NameScope(const TextSet& texts, const std::vector<Item>& items, FileId file, const NameScope* outer,
              const Part* config = nullptr);

    struct Declaration {
        const ParamItem* item = nullptr;
        FileId file = kNoFile;
        const NameScope* scope = nullptr;
    };
    [[nodiscard]] Declaration find(std::string_view name) const;
    /// The config that declares these Params, which instances may set.
    [[nodiscard]] const Part* config() const { return m_config; }
    /// The innermost config around it, or itself; nullptr: it is in none.
    [[nodiscard]] const Part* enclosingConfig() const;

private:
    const NameScope* m_outer = nullptr;
    const Part* m_config = nullptr;
    std::map<std::string_view, Declaration> m_own;
};

} // namespace trundle
