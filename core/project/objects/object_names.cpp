#include "project/objects/object_names.h"

#include <cctype>

#include "lang/characters.h"
#include "model/config_blocks.h"
#include "model/robot_path.h"
#include "project/objects/object_location.h"

namespace trundle {

namespace {

bool isReserved(std::string_view word) { return word == "Param" || word == "true" || word == "false" || word == "world"; }

} // namespace

Status legalName(std::string_view name) {
    if (name.empty()) return Error{Code::MissingName, "a name is missing"};
    const std::string shown(name.substr(0, 60));
    if (isReserved(name)) return Error{Code::ReservedWord, "`" + shown + "` is reserved and cannot be a name"};
    if (!isIdentStart(name[0]) || !std::all_of(name.begin(), name.end(), isIdent))
        return Error{Code::UnexpectedText,
                     "`" + shown + "` cannot be a name: only A-Z a-z 0-9 and _, and no digit at the beginning"};
    return {};
}

std::string legalised(std::string_view preferred) {
    std::string name;
    for (const char c : preferred.substr(0, 60)) name += isIdent(c) ? c : '_';
    if (name.empty() || !isIdentStart(name[0])) name.insert(0, "_");
    return isReserved(name) ? name + "_" : name;
}

std::string lowerFirst(std::string word) {
    if (!word.empty()) word[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(word[0])));
    return word;
}

UsedNames::UsedNames(const LoadedProject& loaded, const Part* parent, const Kind* kind)
    : m_loaded(loaded), m_parent(parent), m_kind(kind) {
    if (parent) return;
    const Outline& o = *loaded.outline;
    if (const NameSpace* space = kind ? o.spaceOf(*kind) : nullptr) m_spaces = {space};
    else m_spaces = {&o.materials, &o.surfaces, &o.patterns, &o.configs, &o.world};
}

std::string UsedNames::inSpace(const NameSpace& space, const std::string& name) const {
    const Outline& outline = *m_loaded.outline;
    if (const Part* part = space.find(name)) return part->title();
    if (&space == &outline.materials || &space == &outline.surfaces) return name == "default" ? "the built-in default" : "";
    if (&space != &outline.world) return {};
    if (const Part* layout = layoutOfMember(outline, name)) return "a member of " + layout->title();
    if (m_kind && m_kind->role != Role::Layout && m_kind->role != Role::Repeat) return {};
    for (const Part* part : space.all())
        if (isMemberOf(part->name, name)) return part->title() + ", as a member would be called";
    return {};
}

/// The block that a path into a robot could mean instead: its controller and the parts of its config must not share a name.
const Part* UsedNames::beside(const std::string& name) const {
    if (isPlaced(*m_parent)) {
        const Part* config = configOf(m_loaded, *m_parent);
        return config ? config->find(name) : nullptr;
    }
    if (!m_parent->is(Role::Config)) return nullptr;
    for (const Part* variant : m_loaded.outline->configs.all()) {
        const Part* part = isVariant(*variant) && variant->config == m_parent ? variant->find(name) : nullptr;
        if (part) return part;
    }
    const Part* found = nullptr;
    eachInWorld(*m_loaded.outline, [&](const Part& instance, const std::string&) {
        const Part* part = isPlaced(instance) && !found ? instance.find(name) : nullptr;
        if (part && configOf(m_loaded, instance) == m_parent) found = part;
    });
    return found;
}

std::string UsedNames::holder(const std::string& name) const {
    if (m_given.count(name)) return "another one";
    for (const NameSpace* space : m_spaces) {
        if (std::string who = inSpace(*space, name); !who.empty()) return who;
    }
    if (!m_parent) {
        // A path that begins with a kind refers to definitions.
        const Kind* kind = m_loaded.registry->find(name);
        const bool world = m_kind && m_loaded.outline->spaceOf(*m_kind) == &m_loaded.outline->world;
        return world && kind && m_loaded.outline->spaceOf(*kind) ? "a kind of block" : "";
    }
    if (const Part* part = m_parent->find(name)) return part->title();
    if (const Part* layout = m_parent->isRepeat() ? inRepeat(*m_parent, name) : nullptr) return "a member of " + layout->title();
    for (const Part& part : m_parent->parts)
        if (m_kind && (m_kind->role == Role::Repeat || m_kind->role == Role::Layout) && isMemberOf(part.name, name))
            return part.title() + ", as a member would be called";
    if (const Part* part = beside(name)) return part->title();
    if (m_parent->is(Role::Config) && m_parent->param(name)) return "Param " + name;
    return {};
}

std::string UsedNames::take(const std::string& preferred) {
    std::string name = legalised(preferred);
    std::size_t digits = name.size();
    while (digits > 1 && isDigit(name[digits - 1]) && name.size() - digits < 9) --digits;
    std::string stem = name.substr(0, digits);
    unsigned long number = digits < name.size() ? std::stoul(name.substr(digits)) : 1;
    if (!m_parent && layoutOfMember(*m_loaded.outline, stem + "0")) { // all names `swarm_<number>` belong to the layout
        stem.pop_back();
        number = 1;
    }
    while (!holder(name).empty()) name = stem + std::to_string(++number);
    m_given.insert(name);
    return name;
}

} // namespace trundle
