#include <algorithm>
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

std::vector<std::string> dependentsOf(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    const std::vector<NameReference> references = referencesIn(loaded);
    std::vector<std::string> all = paths;
    for (;;) {
        const Result<std::vector<Chosen>> gone = chosen(loaded, all);
        if (!gone) return {};
        const std::vector<const NameReference*> users = outsideUsers(references, gone.value());
        if (users.empty()) {
            std::vector<std::string> along;
            for (const Chosen& c : gone.value())
                if (std::find(paths.begin(), paths.end(), c.path) == paths.end()) along.push_back(c.path);
            return along;
        }
        const std::size_t before = all.size();
        std::set<const Part*> going;
        for (const NameReference* m : users) {
            if (!isRemovedToo(*m) || !going.insert(m->user).second) continue;
            all.push_back(objectAt(loaded, m->user->range.file, m->user->range.range.begin));
        }
        if (all.size() == before) return {};
        if (std::any_of(users.begin(), users.end(), [&](const NameReference* m) { return !going.contains(m->user); })) return {};
    }
}

Result<EditPlan> planRemove(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    const Result<std::vector<Chosen>> all = chosen(loaded, paths);
    if (!all.ok()) return all.error();
    const std::vector<NameReference> references = referencesIn(loaded);
    const std::vector<const NameReference*> users = outsideUsers(references, all.value());
    if (!users.empty()) {
        std::string what;
        for (const Chosen& c : all.value()) {
            const bool named = std::any_of(users.begin(), users.end(), [&](const NameReference* m) {
                return removedWith(*c.place.part).contains(m->target);
            });
            if (!named) continue;
            what = what.empty() ? c.place.part->title() : what + " and others";
            if (what.ends_with("others")) break;
        }
        return Error{Code::UnknownReference,
                     what + (what.ends_with("others") ? " are" : " is") + " still used by " + usersText(users)};
    }
    EditBuilder sheet(loaded);
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
