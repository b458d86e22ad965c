// Needs: blocks as text and the requested target. Gives: each block at a valid position, under a free name, with the imports that
// it needs.

#include <set>

#include "lang/characters.h"
#include "lang/edit_style.h"
#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "project/edits/edit_builder.h"
#include "project/edits/pasted_blocks.h"
#include "project/edits/plan_targets.h"
#include "project/loading/import_lines.h"
#include "project/objects/object_names.h"

namespace trundle {

namespace {

/// A block that could receive the new ones, and its path.
struct Target {
    const Part* part = nullptr; ///< nullptr: the top level
    std::string path;
};

/// The location itself, its enclosing blocks, and the config or the instance that it is reached through.
std::vector<Target> nearTo(const LoadedProject& loaded, const ObjectLocation& place, std::string path) {
    std::vector<Target> all{{place.part, path}};
    for (auto it = place.above.rbegin(); it != place.above.rend(); ++it) {
        const bool isHolderOfConfig =
            (*it)->config && all.back().part == (*it)->config; // a Part and its PartConfig have one path
        if (!isHolderOfConfig) path = withoutLastWord(path);
        if (isHolderOfConfig && isVariant(**it)) all.pop_back(); // what is added to a variant is written in it
        all.push_back({*it, path});
    }
    if (!place.instance || place.instance->isPartUse() || isVariant(*place.instance)) return all;
    if (all.back().part != place.instance) all.push_back({place.instance, path}); // same path: its config is reached through it
    else if (const Part* config = configOf(loaded, *place.instance)) all.push_back({config, path});
    return all;
}

bool canHoldControllers(const Part& part) { return isPlaced(part); }

class InsertPlanner {
public:
    InsertPlanner(const LoadedProject& loaded, PastedBlocks blocks, FileId file)
        : m_loaded(loaded), m_blocks(std::move(blocks)), m_sheet(loaded), m_file(file) {}

    Result<EditPlan> into(const std::string& parent, const std::vector<std::string>& imports) {
        const std::optional<ObjectLocation> place = placeOf(m_loaded, parent);
        if (!place) return Error{Code::NoSuchPath, "there is no " + parent};
        if (place->part) m_near = nearTo(m_loaded, *place, parent);
        m_member = place->member;
        for (PastedBlocks::Entry& entry : m_blocks.entries) {
            if (Status status = settle(entry); !status.ok()) return status.error();
        }
        findUser();
        std::vector<std::string> selects;
        for (const auto& [name, param] : m_blocks.params) {
            const SourceParam* there = paramHere(name);
            if (there && !hasSameText(*there, param.value))
                return Error{Code::DuplicateName, "Param " + name + " is " + valueOf(*there) + " here, and " + param.value +
                                                      " where this comes from; rename one of the two first"};
            if (!there) addAtTop(param.text);
        }
        for (std::size_t i = 0; i < m_blocks.entries.size(); ++i) {
            const PastedBlocks::Entry& entry = m_blocks.entries[i];
            if (entry.target) m_sheet.addItem(entry.target->file, entry.target->block, m_blocks.textOf(m_loaded, entry));
            else if (isDefinition(entry)) addAtTop(m_blocks.textOf(m_loaded, entry));
            else m_sheet.addItem(m_file, nullptr, m_blocks.textOf(m_loaded, entry));
            selects.push_back(pathFor(entry, m_paths[i]));
        }
        if (Status status = import(imports); !status.ok()) return status.error();
        if (!m_imports)
            if (Status status = nothingMissing(); !status.ok()) return status.error();
        return m_sheet.plan(std::move(selects));
    }

private:
    /// The first block of the top level that gets some of the blocks: what they need of the top level comes before it.
    void findUser() {
        for (const PastedBlocks::Entry& entry : m_blocks.entries)
            for (const auto& part : m_loaded.outline->parts)
                if (entry.target && isWithin(entry.target->range, part->range) &&
                    (!m_user || isWithin(part->range, {m_user->file, {0, m_user->range.range.begin}})))
                    m_user = part.get();
    }
    bool isDefinition(const PastedBlocks::Entry& entry) const {
        const NameSpace* space = entry.kind ? m_loaded.outline->spaceOf(*entry.kind) : nullptr;
        return space && space != &m_loaded.outline->world;
    }
    void addAtTop(const std::string& text) {
        if (!m_user) return m_sheet.addItem(m_file, nullptr, text);
        addBefore(m_loaded, m_user, m_user->file, restepped(text, editStyle(*m_loaded.trees[m_user->file]).step), m_sheet);
    }

    const SourceParam* paramHere(const std::string& name) const {
        const auto& params = m_loaded.outline->params;
        const auto it = std::find_if(params.begin(), params.end(), [&](const SourceParam& p) { return p.name->text == name; });
        return it == params.end() ? nullptr : &*it;
    }
    std::string valueOf(const SourceParam& param) const {
        return std::string(m_loaded.outline->texts().slice({param.valueFile, param.value->range}));
    }
    bool hasSameText(const SourceParam& param, std::string value) const {
        std::string here = valueOf(param);
        for (std::string* text : {&here, &value}) std::erase_if(*text, isBlank);
        return here == value;
    }

    Status settle(PastedBlocks::Entry& entry) {
        Result<Target> target = targetFor(entry);
        if (!target.ok()) return target.error();
        entry.target = target.value().part;
        m_paths.push_back(target.value().path);
        if (entry.kind && entry.kind->role == Role::Medium)
            if (Status status = oneMedium(); !status.ok()) return status;
        const bool optional = !entry.kind || entry.kind->nameOptional;
        UsedNames& names = namesIn(entry);
        if (entry.block->name) entry.name = names.take(entry.block->name->text);
        else if (!optional) entry.name = names.take(lowerFirst(entry.block->type.text));
        return {};
    }

    Result<Target> targetFor(const PastedBlocks::Entry& entry) const {
        if (!entry.kind) return unknown();
        if (entry.kind->role == Role::Controller && m_member)
            return Error{Code::ReplaceBySingles, "a member of a Grid or Scatter has no text of its own; replace that by single "
                                                 "robots first"};
        Status refused;
        for (auto it = m_near.begin(); it != m_near.end(); ++it) {
            if (!it->part->usable || !isAllowedIn(*entry.kind, it->part)) continue;
            const auto config = std::find_if(it, m_near.end(), [](const Target& t) { return t.part->is(Role::Config); });
            const bool isInBody = std::any_of(it, m_near.end(), [](const Target& t) { return t.part->is(Role::Body); });
            if (isInBody && !heldBy(entry).fitInBody(*entry.kind)) continue;
            const bool isConfigs = it->part->is(Role::Config) || (it->part->isRepeat() && !isInBody);
            Status fits = isConfigs && config != m_near.end() ? fitsIn(*config->part, entry) : Status();
            if (fits.ok()) return *it;
            if (refused.ok()) refused = fits;
        }
        if (isAllowedIn(*entry.kind, nullptr)) return Target{}; // a joint near a config belongs there, others between robots
        if (!refused.ok()) return refused.error();
        return Error{Code::WrongPlace, allowedPlaces(*entry.kind) + ", not " +
                                           (m_near.empty() ? "at the top level" : "in " + m_near.front().part->title())};
    }

    HeldBlocks heldBy(const PastedBlocks::Entry& entry) const {
        std::vector<const BlockItem*> all;
        for (const PastedBlocks::Entry& e : m_blocks.entries) all.push_back(e.block);
        HeldBlocks held;
        held.add(m_loaded, *entry.block, all);
        return held;
    }

    Status fitsIn(const Part& config, const PastedBlocks::Entry& entry) const {
        const HeldBlocks held = heldBy(entry);
        const std::string name = entry.block->name ? " " + entry.block->name->text : "";
        return held.fitsIn(m_loaded, config, entry.block->type.text + name);
    }

    /// The target for an unknown kind, such as one of a module that is not loaded: a robot or a config, as for controllers and
    /// devices.
    Result<Target> unknown() const {
        for (const Target& target : m_near)
            if (canHoldControllers(*target.part) || target.part->is(Role::Config)) return target;
        return Target{};
    }

    Status oneMedium() const {
        for (const Part* part : m_loaded.outline->world.all())
            if (part->is(Role::Medium)) return Error{Code::DuplicateName, "there is a radio medium already: " + part->title()};
        const auto here = std::count_if(m_blocks.entries.begin(), m_blocks.entries.end(),
                                        [](const PastedBlocks::Entry& e) { return e.kind && e.kind->role == Role::Medium; });
        if (here > 1) return Error{Code::DuplicateName, "an experiment can have one radio medium"};
        return {};
    }

    UsedNames& namesIn(const PastedBlocks::Entry& entry) {
        const NameSpace* space = !entry.target && entry.kind ? m_loaded.outline->spaceOf(*entry.kind) : nullptr;
        return m_names.try_emplace({entry.target, space}, m_loaded, entry.target, entry.kind).first->second;
    }

    std::string pathFor(const PastedBlocks::Entry& entry, const std::string& parent) {
        std::string name = entry.name;
        if (name.empty()) name = automatic(entry);
        if (entry.target) return parent + "." + name;
        const NameSpace* space = entry.kind ? m_loaded.outline->spaceOf(*entry.kind) : nullptr;
        return space == &m_loaded.outline->world || !entry.kind ? name : entry.kind->name + "." + name;
    }

    /// The default name of an unnamed block: the next one of its kind.
    std::string automatic(const PastedBlocks::Entry& entry) {
        const std::string& type = entry.block->type.text;
        const auto unnamed = [&](const Part& p) { return !p.block->name && p.block->type.text == type; };
        int& count = m_unnamed.try_emplace({entry.target, type}, 0).first->second;
        if (count == 0) {
            if (entry.target)
                count = static_cast<int>(std::count_if(entry.target->parts.begin(), entry.target->parts.end(), unnamed));
            else
                for (const auto& part : m_loaded.outline->parts) count += unnamed(*part);
        }
        UsedNames& names = namesIn(entry);
        const std::string base = lowerFirst(type);
        for (;;) {
            ++count;
            std::string name = count == 1 ? base : base + std::to_string(count);
            if (names.holder(name).empty()) return names.take(name);
        }
    }

    /// Adds the missing imports to each file that receives a block.
    Status import(std::vector<std::string> imports) {
        imports.insert(imports.end(), m_blocks.directives.begin(), m_blocks.directives.end());
        std::set<FileId> files;
        for (const PastedBlocks::Entry& entry : m_blocks.entries)
            files.insert(entry.target ? entry.target->file : m_user && isDefinition(entry) ? m_user->file : m_file);
        if (files.empty()) files.insert(m_file);
        for (const FileId file : files) {
            Result<std::vector<TextEdit>> edits = editsForImports(m_loaded, file, imports);
            if (!edits.ok()) return edits.error();
            m_imports = m_imports || !edits.value().empty();
            for (TextEdit& edit : edits.value()) m_sheet.addFirst(std::move(edit));
        }
        return {};
    }

    /// Checks that all names used are defined. Only possible without new imports.
    Status nothingMissing() const {
        for (const PastedBlocks::Entry& entry : m_blocks.entries) {
            std::vector<const Part*> round;
            for (const Target& target : m_near) // ordered from the innermost outwards
                if (entry.target &&
                    (target.part == entry.target || (!round.empty() && isWithin(entry.target->range, target.part->range))))
                    round.insert(round.begin(), target.part);
            const std::string what = m_blocks.missing(m_loaded, entry, round);
            if (!what.empty())
                return Error{Code::UnknownReference,
                             entry.block->type.text + " " + entry.name + (entry.name.empty() ? "uses " : " uses ") + what +
                                 (entry.target ? ", which " + entry.target->title() + " does not have" : ", which is not here")};
        }
        return {};
    }

    const LoadedProject& m_loaded;
    PastedBlocks m_blocks;
    EditBuilder m_sheet;
    const FileId m_file; ///< for blocks at the top level
    std::vector<Target> m_near;
    const Part* m_user = nullptr; ///< see findUser()
    bool m_member = false, m_imports = false;
    std::vector<std::string> m_paths; ///< of the inserted blocks
    std::map<std::pair<const Part*, const NameSpace*>, UsedNames> m_names;
    std::map<std::pair<const Part*, std::string>, int> m_unnamed;
};

} // namespace

Result<EditPlan> planInsert(const LoadedProject& loaded, const std::string& parent, const std::string& text,
                            const std::vector<std::string>& imports, FileId file) {
    Result<PastedBlocks> blocks = PastedBlocks::read(*loaded.registry, text);
    if (!blocks.ok()) return blocks.error();
    return InsertPlanner(loaded, std::move(blocks).value(), file).into(parent, imports);
}

} // namespace trundle
