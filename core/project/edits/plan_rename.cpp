// Needs: a load and the path of a part or Param. Gives: edits that rename it and update all references.

#include <set>

#include "base/spelling.h"
#include "model/dotted_path.h"
#include "project/edits/edit_builder.h"
#include "project/edits/plans.h"
#include "project/objects/name_scope.h"
#include "project/objects/object_names.h"

namespace trundle {

namespace {

/// All parts that one block of text represents: several if more than one block imports its file.
void partsOf(const std::vector<Part>& parts, const Part* parent, const BlockItem* block,
             std::vector<std::pair<const Part*, const Part*>>& found) {
    for (const Part& part : parts) {
        if (part.block == block) found.emplace_back(&part, parent);
        partsOf(part.parts, &part, block, found);
    }
}

Error takenBy(const std::string& name, const std::string& who) {
    return {Code::DuplicateName, "the name " + name + " is taken by " + who};
}

class RenamePlanner {
public:
    RenamePlanner(const LoadedProject& loaded, std::string name)
        : m_loaded(loaded), m_name(std::move(name)), m_references(referencesIn(loaded)), m_sheet(loaded) {}

    Result<EditPlan> part(const ObjectLocation& place, const std::string& path) {
        const Part& part = *place.part;
        std::vector<std::pair<const Part*, const Part*>> all;
        if (place.above.empty()) all.emplace_back(&part, nullptr);
        for (const auto& top : m_loaded.outline->parts) partsOf(top->parts, top.get(), part.block, all);
        for (const auto& [same, parent] : all) {
            const UsedNames taken(m_loaded, parent, part.kind);
            if (const std::string who = taken.holder(m_name); !who.empty() && m_name != same->name) return takenBy(m_name, who);
        }
        m_sheet.name(*part.block, part.file, m_name);
        for (const auto& [same, parent] : all)
            if (!part.block->name && parent) keepNames(parent->parts, part.block->type.text, m_references, {same}, m_sheet);
        const Status done = change([&](const NameReference& m) { return m.target == part.block; });
        if (!done.ok()) return done.error();
        const auto isConfig = [](const Part* p) { return p->is(Role::Config); };
        const auto holder = std::find_if(place.above.rbegin(), place.above.rend(), isConfig);
        return planIn(holder == place.above.rend() ? nullptr : *holder, {pathInside(withoutLastWord(path), m_name)});
    }

    /// `owner`: the block that declares it.
    Result<EditPlan> param(const ParamItem& param, FileId file, const Part* owner) {
        m_sheet.add({{file, param.name.range}, m_name});
        const Status done = change([&](const NameReference& m) { return m.param == &param; });
        if (!done.ok()) return done.error();
        return planIn(owner && owner->is(Role::Config) ? owner : nullptr, {});
    }

    /// A Param that `config` uses and no text declares.
    Result<EditPlan> implied(const SourceParam& param, const Part& config) {
        const Status done = change([&](const NameReference& m) { return m.implied == param.name; });
        if (!done.ok()) return done.error();
        return planIn(&config, {});
    }

private:
    Result<EditPlan> planIn(const Part* config, std::vector<std::string> selects) {
        Result<EditPlan> plan = m_sheet.plan(std::move(selects));
        if (plan.ok() && config) plan.value().renamedIn = pathOfConfig(*config);
        return plan;
    }

    template <class Means> Status change(const Means& means) {
        std::set<SourceRange> mine;
        for (const NameReference& m : m_references) {
            if (!means(m) || !m.name.known()) continue;
            if (const Part* other = m.lookedUpFirst ? m.lookedUpFirst->find(m_name) : nullptr)
                return Error{Code::Conflict, usersText({&m}) + " would then name " + other->title()};
            mine.insert(m.name);
        }
        for (const NameReference& m : m_references) { // repeated for a file imported twice, or a pattern for several robots
            if (means(m) || !mine.count(m.name)) continue;
            if (m.pattern) mine.erase(m.name);
            else
                return Error{Code::Conflict,
                             "a text that several blocks import names it: " + usersText({&m}) + " would then name nothing"};
        }
        for (const SourceRange& range : mine) m_sheet.add({range, m_name});
        for (const NameReference& m : m_references)
            if (means(m) && !m.name.known() && m.user) m_sheet.addAssignment(m.user->file, m.user->block, m.property, m_name);
        return {};
    }

    const LoadedProject& m_loaded;
    const std::string m_name;
    const std::vector<NameReference> m_references;
    EditBuilder m_sheet;
};

struct FoundParam {
    const SourceParam* param = nullptr;
    const Part* owner = nullptr; ///< nullptr: the top level
};

/// Finds a Param by path: "RobotConfig.Rover.trackWidth", "robot0.trackWidth" (of its config), "side" or "Param.side" at the top
/// level.
FoundParam findParam(const LoadedProject& loaded, std::string_view path) {
    if (path.starts_with("Param.")) path.remove_prefix(6);
    const std::string name(lastWord(path));
    if (name == path) {
        for (const SourceParam& p : loaded.outline->params)
            if (p.name->text == name) return {&p, nullptr};
        return {};
    }
    const std::optional<ObjectLocation> place = placeOf(loaded, withoutLastWord(path));
    if (!place || !place->part) return {};
    if (const SourceParam* own = place->part->param(name)) return {own, place->part};
    const Part* config = place->part == place->instance ? configOf(loaded, *place->part) : nullptr;
    if (const SourceParam* theirs = config ? config->param(name) : nullptr) return {theirs, config};
    return {};
}

const ParamItem* itemOf(const std::vector<Item>& items, const Name* name) {
    for (const Item& item : items) {
        if (const auto* param = item.as<ParamItem>(); param && &param->name == name) return param;
        const auto* block = item.as<BlockItem>();
        if (const ParamItem* inside = block ? itemOf(block->items, name) : nullptr) return inside;
    }
    return nullptr;
}

bool declaresInside(const Part& part, const std::string& name) {
    return part.param(name) ||
           std::any_of(part.parts.begin(), part.parts.end(), [&](const Part& inner) { return declaresInside(inner, name); });
}

/// Fails if the new name of a Param has another meaning where the Param is used or set.
Status freeForParam(const LoadedProject& loaded, const FoundParam& found, const std::string& name) {
    if (name == "pi") return takenBy(name, "the number pi");
    const Outline& outline = *loaded.outline;
    for (const Kind* kind : loaded.registry->all()) {
        const bool set = found.owner ? kind->role == Role::Instance || kind->role == Role::Layout || kind == found.owner->kind
                                     : kind->role == Role::Settings;
        if (set && kind->find(name)) return takenBy(name, "a property of " + kind->name);
    }
    for (const SourceParam& p : outline.params)
        if (p.name->text == name) return takenBy(name, "a Param of the top level");
    if (found.owner && found.owner->find(name)) return takenBy(name, found.owner->find(name)->title());
    const auto declared = [&](const auto& part) { return declaresInside(*part, name); };
    const bool inside =
        found.owner ? declaresInside(*found.owner, name) : std::any_of(outline.parts.begin(), outline.parts.end(), declared);
    if (inside) return takenBy(name, "another Param");
    for (const Part* part : outline.world.all()) // its values could then mean the instance's Param
        if (found.owner && isPlaced(*part) && configOf(loaded, *part) == found.owner && declaresInside(*part, name))
            return takenBy(name, "a Param of " + part->title());
    return {};
}

/// `$name` with a name like that of another Param counts as that, misspelt, and not as one that Parts give.
Result<EditPlan> planRenameImplied(const LoadedProject& loaded, const FoundParam& found, const std::string& name) {
    std::vector<std::string> others;
    for (const SourceParam& p : found.owner->params)
        if (p.name != found.param->name) others.push_back(p.name->text);
    if (const std::vector<std::string> near = nearestWords(name, others); !near.empty())
        return Error{Code::Conflict, "$" + name + " would be taken for a misspelt $" + near.front()};
    return RenamePlanner(loaded, name).implied(*found.param, *found.owner);
}

} // namespace

Result<EditPlan> planRename(const LoadedProject& loaded, const std::string& path, const std::string& name) {
    if (Status legal = legalName(name); !legal.ok()) return legal.error();
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    if (place && place->part) {
        if (place->member && place->within.empty())
            return Error{Code::ReplaceBySingles,
                         path + " is a member of " + place->part->title() + " and has no name of its own"};
        if (place->part->name == name && place->part->block->name) return EditPlan{{}, {path}};
        return RenamePlanner(loaded, name).part(*place, path);
    }
    const FoundParam found = findParam(loaded, path);
    if (!found.param) return Error{Code::NoSuchPath, path.empty() ? "the experiment has no name" : "there is no " + path};
    if (found.param->name->text == name) return EditPlan{};
    if (Status open = freeForParam(loaded, found, name); !open.ok()) return open.error();
    if (!found.param->item) return planRenameImplied(loaded, found, name);
    const ParamItem* item = itemOf(loaded.trees[found.param->file]->items(), found.param->name);
    if (!item) return Error{Code::NoSuchPath, "there is no " + path};
    return RenamePlanner(loaded, name).param(*item, found.param->file, found.owner);
}

} // namespace trundle
