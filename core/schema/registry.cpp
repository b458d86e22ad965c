#include "schema/registry.h"

#include <algorithm>

#include "schema/allowed_parents.h"

namespace trundle {

namespace {

std::string owner(const Kind& kind) { return kind.module.empty() ? "the program itself" : kind.module; }

} // namespace

Status Registry::add(Kind kind) {
    const auto it = m_kinds.find(kind.name);
    if (it != m_kinds.end()) {
        return Error{Code::ModuleDuplicateKind,
                     "the kind " + kind.name + " comes from " + owner(it->second) + " and again from " + owner(kind)};
    }
    std::string name = kind.name;
    m_kinds.emplace(std::move(name), std::move(kind));
    return {};
}

const Kind* Registry::find(std::string_view name) const {
    const auto it = m_kinds.find(name);
    return it == m_kinds.end() ? nullptr : &it->second;
}

std::vector<const Kind*> Registry::all() const {
    std::vector<const Kind*> kinds;
    kinds.reserve(m_kinds.size());
    for (const auto& [name, kind] : m_kinds) kinds.push_back(&kind);
    return kinds;
}

std::vector<const Kind*> Registry::inside(std::string_view parent) const {
    std::vector<const Kind*> kinds;
    for (const auto& [name, kind] : m_kinds) {
        if (isAllowedInside(kind, parent)) kinds.push_back(&kind);
    }
    return kinds;
}

} // namespace trundle
