// Needs: a config. Gives: the names of what is in it, for references of a new block.
// Method: level by level, first the config's own blocks, then those of its Parts and Repeats, so that the nearest come first and a limit
// cuts off the others.
#include "project/edits/template_names.h"

#include <algorithm>

#include "model/config_blocks.h"
#include "model/repeat.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr std::size_t kMostBlocks = 5000, kMostHolders = 2000;

/// "left.front." becomes "left.".
void dropLastWord(std::string& prefix) {
    prefix.pop_back();
    prefix.resize(prefix.rfind('.') + 1); // npos + 1 is 0
}

} // namespace

bool fitsChoice(const Part& part, const std::string& choice) {
    return part.usable && part.kind && (choice == part.kind->name || choice == roleName(part.kind->role));
}

TemplateNames::TemplateNames(const LoadedProject& loaded, const Part& config, const std::vector<const Part*>& repeats)
    : m_loaded(loaded), m_config(config) {
    for (const Part* repeat : repeats) m_inside += repeat->name + "_0.";
    m_open.push_back({&config, {}, {}, 0});
    for (std::size_t i = 0; i < m_open.size(); ++i) add(Holder(m_open[i]), repeats);
    sortByDistance();
    for (std::size_t i = 0; i < m_all.size(); ++i) {
        m_byName.emplace(m_all[i].name, i);
        m_byWritten.emplace(written(m_all[i].name), i); // what is farther out is hidden by what is inside
    }
}

void TemplateNames::add(const Holder& holder, const std::vector<const Part*>& repeats) {
    eachBlock(*holder.part, [&](const Part& part) {
        if (!part.usable || !part.kind || (holder.depth > 0 && m_all.size() >= kMostBlocks)) return;
        const std::string name = holder.prefix + part.name;
        if (part.isRepeat()) return addMembers(part, holder, std::ranges::count(repeats, &part) > 0);
        if (part.isPartUse()) {
            if (part.config && m_open.size() < kMostHolders)
                m_open.push_back({&part, name + ".", holder.prefix, holder.depth + 1});
            return;
        }
        m_all.push_back({&part, name, holder.prefix, holder.outside, holder.depth});
        if (part.is(Role::Body)) add({&part, name + ".", holder.outside, holder.depth}, repeats);
    });
}

void TemplateNames::addMembers(const Part& repeat, const Holder& around, bool isOnlyFirst) {
    const std::string name = around.prefix + repeat.name;
    const std::optional<ObjectLocation> place = isOnlyFirst ? std::nullopt : locationOf(name);
    const std::optional<PropertyValue> count = place ? valueAt(m_loaded, *place, "Count") : std::nullopt;
    const std::size_t members = count ? memberCount(count->numbers) : 1;
    for (std::size_t i = 0; i < members && m_open.size() < kMostHolders; ++i)
        m_open.push_back({&repeat, name + "_" + std::to_string(i) + ".", around.outside, around.depth + 1});
}

/// From inside of the Repeats outwards.
void TemplateNames::sortByDistance() {
    std::string around = m_inside;
    for (auto from = m_all.begin(); !around.empty(); dropLastWord(around))
        from = std::stable_partition(from, m_all.end(), [&](const NamedBlock& b) { return b.name.starts_with(around); });
}

/// The name from inside of the Repeats.
std::string TemplateNames::written(const std::string& name) const {
    std::string around = m_inside;
    while (!around.empty() && !name.starts_with(around)) dropLastWord(around);
    return name.substr(around.size());
}

std::vector<std::string> TemplateNames::fitting(const std::string& choice) const {
    std::vector<std::string> names;
    for (const NamedBlock& block : m_all)
        if (fitsChoice(*block.part, choice) && find(written(block.name)) == &block) names.push_back(written(block.name));
    return names;
}

const NamedBlock* TemplateNames::find(const std::string& name) const {
    const auto it = m_byWritten.find(name);
    return it == m_byWritten.end() ? nullptr : &m_all[it->second];
}

bool TemplateNames::isChild(const std::string& body) const {
    const auto [it, isNew] = m_used.try_emplace({nullptr, "Child"});
    if (isNew)
        for (const NamedBlock& block : m_all)
            if (block.part->is(Role::Joint)) it->second.insert(named(block, "Child"));
    const NamedBlock* block = find(body);
    return block && it->second.contains(block);
}

bool TemplateNames::isUsed(const Kind& kind, const std::string& property, const std::string& name) const {
    const auto [it, isNew] = m_used.try_emplace({&kind, property});
    if (isNew)
        for (const NamedBlock& block : m_all)
            if (block.part->kind == &kind)
                for (const NamedBlock* used : allNamed(block, property)) it->second.insert(used);
    const NamedBlock* block = find(name);
    return block && it->second.contains(block);
}

const NamedBlock* TemplateNames::named(const NamedBlock& block, const std::string& property) const {
    const std::vector<const NamedBlock*> all = allNamed(block, property);
    return all.empty() ? nullptr : all.front();
}

/// A word is looked up beside the block; one that a Param brings in, outside of the Part.
std::vector<const NamedBlock*> TemplateNames::allNamed(const NamedBlock& block, const std::string& property) const {
    const SourceAssignment* a = block.part->assignments.find(property);
    const auto has = [&](Element::Kind kind) {
        return a && std::ranges::any_of(a->value->elements, [&](const Element& e) { return e.kind == kind; });
    };
    const bool isParam = has(Element::Kind::ParamRef);
    std::vector<std::string> words;
    if (a && block.depth == 0 && !isParam && !has(Element::Kind::Expression)) { // the usual case, for configs of very many blocks
        for (const Element& e : a->value->elements) words.push_back(e.text);
    } else if (const std::optional<ObjectLocation> place = locationOf(block.name)) {
        if (const auto value = valueAt(m_loaded, *place, property)) words = value->texts;
    }
    std::vector<const NamedBlock*> all;
    for (const std::string& word : words) {
        std::string from = isParam ? block.outside : block.prefix;
        auto it = m_byName.find(from + word);
        while (it == m_byName.end() && !from.empty()) {
            dropLastWord(from);
            it = m_byName.find(from + word);
        }
        if (it != m_byName.end()) all.push_back(&m_all[it->second]);
    }
    return all;
}

std::optional<ObjectLocation> TemplateNames::locationOf(const std::string& nameInConfig) const {
    std::optional<ObjectLocation> place = placeOf(m_loaded, pathOfConfig(m_config) + "." + nameInConfig);
    return place && place->part && place->part->kind ? place : std::nullopt;
}

} // namespace trundle
