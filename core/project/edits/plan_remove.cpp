// needs        the blocks to remove, and all references
// assumptions  a reference in a list with other names needs no block of its own: the list loses that name, NoContact the pair
// method       lists are shortened as long as enough names stay; a block that refers to a removed one otherwise, or whose list
//             would have too few, has to be removed too

#include <algorithm>
#include <map>
#include <set>

#include "project/edits/edit_builder.h"
#include "project/edits/edit_target.h"
#include "project/edits/obsolete_import.h"
#include "project/edits/plan_dependents.h"
#include "project/edits/plan_targets.h"
#include "project/loading/import_lines.h"
#include "project/loading/search.h"

namespace trundle {
namespace {

void addBlocks(const Part& part, std::set<const BlockItem*>& blocks) {
    blocks.insert(part.block);
    for (const Part& inner : part.parts) addBlocks(inner, blocks);
}

/// The blocks whose text is removed. Blocks from imported files are kept: other files may use them.
std::set<const BlockItem*> removedWith(const Part& part) {
    std::set<const BlockItem*> blocks;
    const auto add = [&](const auto& self, const Part& p) -> void {
        if (isWithin(p.range, part.range)) blocks.insert(p.block);
        for (const Part& inner : p.parts) self(self, inner);
    };
    add(add, part);
    return blocks;
}

/// References from outside to the removed objects or their contents.
std::vector<const NameReference*> outsideUsers(const std::vector<NameReference>& references, const std::vector<Chosen>& all) {
    std::set<const BlockItem*> blocks, gone;
    for (const Chosen& c : all) {
        addBlocks(*c.place.part, blocks);
        gone.merge(removedWith(*c.place.part));
    }
    const auto isGone = [&](const SourceRange& name) {
        return std::any_of(all.begin(), all.end(), [&](const Chosen& c) { return isWithin(name, c.place.part->range); });
    };
    std::vector<const NameReference*> users;
    for (const NameReference& m : references) {
        if (!m.target || !gone.count(m.target) || !m.name.known() || m.pattern) continue;
        if (!isGone(m.name) && !(m.user && blocks.count(m.user->block))) users.push_back(&m);
    }
    return users;
}

/// A value with several names, and which of them are removed.
struct NameList {
    const SourceAssignment* assignment = nullptr;
    const NameReference* user = nullptr; ///< the first one
    std::size_t least = 0;               ///< so many have to stay
    std::set<std::size_t> gone = {};

    [[nodiscard]] const std::vector<Element>& elements() const { return assignment->value->elements; }
    [[nodiscard]] bool isPairs() const { return assignment->key == "NoContact"; }
    [[nodiscard]] bool keepsEnough() const { return elements().size() >= gone.size() + least; }

    void remove(const SourceRange& name) {
        for (std::size_t i = 0; i < elements().size(); ++i) {
            if (!isWithin(name, {assignment->file, elements()[i].range})) continue;
            gone.insert(i);
            if (isPairs()) gone.insert(i ^ 1U);
        }
    }
    /// Removes the names with their commas; the whole assignment if none stays.
    void write(EditBuilder& sheet) const {
        const std::vector<Element>& all = elements();
        if (gone.size() == all.size())
            return sheet.removeItem({assignment->file, {assignment->keyRange().range.begin, all.back().range.end}});
        for (std::size_t begin = 0; begin < all.size(); ++begin) {
            std::size_t end = begin;
            while (gone.contains(end)) ++end;
            if (end == begin) continue;
            const bool isLast = end == all.size();
            const TextRange text = isLast ? TextRange{all[begin - 1].range.end, all[end - 1].range.end}
                                          : TextRange{all[begin].range.begin, all[end].range.begin};
            sheet.add({{assignment->file, text}, ""});
            begin = end;
        }
    }
};

/// Whether other values of the block go with the elements of a list, as the WheelAngles of an OmniDrive with its Motors.
bool hasParallelList(const Part& user, const SourceAssignment& list) {
    return std::ranges::any_of(user.assignments.all(), [&](const SourceAssignment& a) {
        const Property* property = user.kind->find(a.key);
        return property && property->type == PropertyType::Number && property->minCount != property->maxCount &&
               a.value->elements.size() == list.value->elements.size();
    });
}

/// The list that a reference is in; nothing for a single name, and for one that a Param or an override gives.
std::optional<NameList> listOf(const LoadedProject& loaded, const NameReference& m) {
    const Kind* kind = m.user ? m.user->kind : loaded.registry->find("settings");
    const Property* property = kind ? kind->find(m.property) : nullptr;
    const SourceAssignment* a = (m.user ? m.user->assignments : loaded.outline->settings).find(m.property);
    if (!property || !a || !isWithin(m.name, a->valueRange())) return std::nullopt;
    NameList list{a, &m};
    list.least = list.isPairs() ? 0 : std::max<std::size_t>(property->minCount, 1);
    const std::size_t size = list.elements().size();
    if (size < 2 || (list.isPairs() ? size % 2 != 0 : m.user && hasParallelList(*m.user, *a))) return std::nullopt;
    return list;
}

/// The references to what is removed: in lists that are shortened, and all others.
struct GroupedReferences {
    std::map<const Value*, NameList> lists;
    std::vector<const NameReference*> others;
};
GroupedReferences groupByList(const LoadedProject& loaded, const std::vector<const NameReference*>& references) {
    GroupedReferences users;
    std::vector<std::pair<const NameReference*, const Value*>> inLists;
    for (const NameReference* m : references) {
        std::optional<NameList> list = listOf(loaded, *m);
        const Value* value = list ? list->assignment->value : nullptr;
        inLists.emplace_back(m, value);
        if (list) users.lists.try_emplace(value, std::move(*list)).first->second.remove(m->name);
    }
    std::erase_if(users.lists, [](const auto& list) { return !list.second.keepsEnough(); });
    for (const auto& [m, value] : inLists)
        if (!users.lists.contains(value)) users.others.push_back(m);
    return users;
}

/// Whether a block becomes useless without the block that it refers to.
bool isRemovedToo(const NameReference& reference) {
    if (!reference.user) return false;
    const Part& user = *reference.user;
    for (const Role role : {Role::Joint, Role::Device, Role::Controller, Role::Log, Role::Look, Role::Region})
        if (user.is(role)) return true;
    return isPlaced(user) && reference.property == "Config";
}

/// Of a definition that came with the program and is read-only, and that nothing refers to.
Status removeImportOf(const LoadedProject& loaded, const Part& definition, EditBuilder& sheet) {
    const std::optional<ObsoleteImport> unused = unusedImport(loaded, definition, {}, 0);
    if (!unused)
        return Error{Code::FileUnwritable,
                     definition.title() + " is read-only, it came with Trundle in " +
                         shownInProject(loaded.paths[definition.file], loaded.projectFolder) +
                         ", which is imported for other things that are used; it may stay, nothing uses it"};
    sheet.removeItem(unused->directive);
    Result<std::vector<TextEdit>> imports = editsForImports(loaded, 0, unused->needed, unused->import);
    if (!imports.ok()) return imports.error();
    for (TextEdit& edit : imports.value()) sheet.addFirst(std::move(edit));
    return {};
}

} // namespace

Dependents dependentsOf(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    const std::vector<NameReference> references = referencesIn(loaded);
    std::vector<std::string> all = paths;
    for (;;) {
        const Result<std::vector<Chosen>> gone = chosen(loaded, all);
        if (!gone) return {};
        const GroupedReferences users = groupByList(loaded, outsideUsers(references, gone.value()));
        if (users.others.empty()) {
            Dependents found;
            for (const Chosen& c : gone.value())
                if (std::find(paths.begin(), paths.end(), c.path) == paths.end()) found.removed.push_back(c.path);
            for (const auto& [value, list] : users.lists)
                found.shortened.push_back(list.user->user ? list.user->user->title() : list.user->property);
            std::ranges::sort(found.shortened);
            found.shortened.erase(std::unique(found.shortened.begin(), found.shortened.end()), found.shortened.end());
            return found;
        }
        const std::size_t before = all.size();
        std::set<const Part*> going;
        for (const NameReference* m : users.others) {
            if (!isRemovedToo(*m) || !going.insert(m->user).second) continue;
            all.push_back(objectAt(loaded, m->user->range.file, m->user->range.range.begin));
        }
        if (all.size() == before) return {};
        if (std::any_of(users.others.begin(), users.others.end(),
                        [&](const NameReference* m) { return !going.contains(m->user); }))
            return {};
    }
}

Result<EditPlan> planRemove(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    const Result<std::vector<Chosen>> all = chosen(loaded, paths);
    if (!all.ok()) return all.error();
    const std::vector<NameReference> references = referencesIn(loaded);
    const GroupedReferences users = groupByList(loaded, outsideUsers(references, all.value()));
    if (!users.others.empty()) {
        std::string what;
        for (const Chosen& c : all.value()) {
            const bool named = std::any_of(users.others.begin(), users.others.end(), [&](const NameReference* m) {
                return removedWith(*c.place.part).contains(m->target);
            });
            if (!named) continue;
            what = what.empty() ? c.place.part->title() : what + " and others";
            if (what.ends_with("others")) break;
        }
        return Error{Code::UnknownReference,
                     what + (what.ends_with("others") ? " are" : " is") + " still used by " + usersText(users.others)};
    }
    EditBuilder sheet(loaded);
    for (const auto& [value, list] : users.lists) list.write(sheet);
    for (const Chosen& c : all.value()) {
        const Part& part = *c.place.part;
        if (c.place.above.empty() && isShippedFile(loaded, part.file)) {
            if (Status done = removeImportOf(loaded, part, sheet); !done) return done.error();
            continue;
        }
        sheet.removeItem(withOwnComments(loaded, part.range, rangesOf(all.value())));
        if (part.block->name || c.place.above.empty()) continue;
        std::vector<const Part*> except;
        for (const Chosen& other : all.value()) except.push_back(other.place.part);
        keepNames(c.place.above.back()->parts, part.block->type.text, references, except, sheet);
    }
    return sheet.plan({});
}

} // namespace trundle
