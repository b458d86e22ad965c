#include "model/part.h"

#include <algorithm>
#include <optional>

#include "model/dotted_path.h"

namespace trundle {

void Part::makeIndex() {
    if (parts.size() <= 16) return; // a linear search is as fast
    for (std::size_t i = 0; i < parts.size(); ++i) index.emplace(parts[i].name, i);
}

const Part* Part::find(std::string_view part) const {
    if (const Part* own = findOwn(part)) return own;
    const std::optional<MemberName> member = memberName(part);
    const Part* repeat = member ? findOwn(member->stem) : nullptr;
    if (repeat && repeat->isRepeat()) return repeat;
    return config ? config->find(part) : nullptr;
}

const Part* Part::findOwn(std::string_view part) const {
    if (!index.empty()) {
        const auto it = index.find(std::string(part));
        return it == index.end() ? nullptr : &parts[it->second];
    }
    const auto it = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.name == part; });
    return it == parts.end() ? nullptr : &*it;
}

const Part* Part::findPath(std::string_view path) const {
    const Part* at = find(firstWord(path));
    while (at && firstWord(path) != path) { // an empty word, as in "arm.", is no name
        path = withoutFirstWord(path);
        at = at->find(firstWord(path));
    }
    return at;
}

const SourceParam* Part::param(std::string_view key) const {
    const auto it = std::find_if(params.begin(), params.end(), [&](const SourceParam& p) { return p.name->text == key; });
    return it == params.end() ? nullptr : &*it;
}

const Part* NameSpace::find(std::string_view name) const {
    const auto own = [&](std::string_view word) {
        const auto it = m_byName.find(word);
        return it == m_byName.end() ? nullptr : it->second;
    };
    if (const Part* part = own(name)) return part;
    std::string_view rest = name;
    const std::optional<MemberName> member = memberName(firstWord(rest));
    const Part* part = own(firstWord(rest));
    if (!part && member) part = own(member->stem);
    for (; part && firstWord(rest) != rest; part = part->isRepeat() ? part->find(firstWord(rest)) : nullptr)
        rest = withoutFirstWord(rest);
    const bool isNamed = part && (part->isRepeat() || name != firstWord(name));
    return isNamed ? part : nullptr;
}

std::vector<std::string> NameSpace::names() const {
    std::vector<std::string> names;
    names.reserve(m_all.size());
    for (const Part* part : m_all) names.push_back(part->name);
    return names;
}

const Part* NameSpace::add(const Part& part) {
    const auto [it, fresh] = m_byName.emplace(part.name, &part);
    if (!fresh) return it->second;
    m_all.push_back(&part);
    return nullptr;
}

std::vector<std::string> propertyNames(const Kind& kind) {
    std::vector<std::string> names;
    for (const Property& p : kind.properties) names.push_back(p.name);
    return names;
}

const char* roleName(Role role) {
    switch (role) {
    case Role::Settings: return "Settings";
    case Role::Material: return "Material";
    case Role::Surface: return "Surface";
    case Role::Pattern: return "Pattern";
    case Role::Medium: return "Medium";
    case Role::Config: return "Config";
    case Role::Instance: return "Instance";
    case Role::Layout: return "Layout";
    case Role::Repeat: return "Repeat";
    case Role::Body: return "Body";
    case Role::Geom: return "Geom";
    case Role::Joint: return "Joint";
    case Role::Device: return "Device";
    case Role::Controller: return "Controller";
    case Role::Log: return "Log";
    case Role::Look: return "Look";
    case Role::Region: return "Region";
    }
    return "";
}

} // namespace trundle
