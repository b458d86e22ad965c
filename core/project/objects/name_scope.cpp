#include "project/objects/name_scope.h"

namespace trundle {

namespace {

void expand(const TextSet& texts, const std::vector<Item>& items, FileId file, std::unordered_set<FileId>& visited,
            const std::function<void(const Item&, FileId)>& take) {
    for (const Item& item : items) {
        take(item, file);
        const auto* import = item.as<ImportItem>();
        const auto target = import ? texts.imports.find(import) : texts.imports.end();
        if (target != texts.imports.end() && visited.insert(target->second).second)
            expand(texts, texts.trees[target->second]->items(), target->second, visited, take);
    }
}

} // namespace

void eachItem(const TextSet& texts, const std::vector<Item>& items, FileId file,
              const std::function<void(const Item&, FileId)>& take) {
    std::unordered_set<FileId> visited{file};
    expand(texts, items, file, visited, take);
}

NameScope::NameScope(const TextSet& texts, const std::vector<Item>& items, FileId file, const NameScope* outer,
                     const Part* config)
    : m_outer(outer), m_config(config) {
    eachItem(texts, items, file, [&](const Item& item, FileId in) {
        if (const auto* param = item.as<ParamItem>()) m_own.try_emplace(param->name.text, Declaration{param, in, this});
    });
}

NameScope::Declaration NameScope::find(std::string_view name) const {
    for (const NameScope* scope = this; scope; scope = scope->m_outer) {
        const auto it = scope->m_own.find(name);
        if (it != scope->m_own.end()) return {it->second.item, it->second.file, scope};
    }
    return {};
}

const Part* NameScope::enclosingConfig() const {
    const NameScope* scope = this;
    while (scope && !scope->m_config) scope = scope->m_outer;
    return scope ? scope->m_config : nullptr;
}

} // namespace trundle
