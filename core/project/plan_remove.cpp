#include <set>

#include "project/edit_sheet.h"
#include "project/plan_targets.h"

namespace trundle {

Result<EditPlan> planRemove(const Loaded& loaded, const std::vector<std::string>& paths) {
    const Result<std::vector<Chosen>> all = chosen(loaded, paths);
    if (!all.ok()) return all.error();
    std::vector<SourceRange> gone;
    for (const Chosen& c : all.value()) gone.push_back(c.place.part->range);
    const auto isGone = [&](FileId file, TextRange range) {
        return std::any_of(gone.begin(), gone.end(), [&](const SourceRange& g) { return isWithin({file, range}, g); });
    };
    const std::vector<Mention> mentions = mentionsIn(loaded);
    std::set<const BlockItem*> blocks; // of all that goes
    const auto collect = [&](const auto& self, const Part& part) -> void {
        blocks.insert(part.block);
        for (const Part& inner : part.parts) self(self, inner);
    };
    for (const Chosen& c : all.value()) collect(collect, *c.place.part);
    std::vector<const Mention*> users;
    for (const Mention& m : mentions) {
        if (!m.target || !blocks.count(m.target) || !m.name.known() || m.pattern) continue;
        if (!isGone(m.name.file, m.name.range) && !(m.user && blocks.count(m.user->block))) users.push_back(&m);
    }
    if (!users.empty()) {
        std::string what;
        for (const Chosen& c : all.value()) {
            const bool named = std::any_of(users.begin(), users.end(), [&](const Mention* m) {
                std::set<const BlockItem*> own;
                const auto look = [&](const auto& self, const Part& part) -> void {
                    own.insert(part.block);
                    for (const Part& inner : part.parts) self(self, inner);
                };
                look(look, *c.place.part);
                return own.count(m->target) > 0;
            });
            if (!named) continue;
            what = what.empty() ? c.place.part->title() : what + " and others";
            if (what.ends_with("others")) break;
        }
        return Error{Code::UnknownReference,
                     what + (what.ends_with("others") ? " are" : " is") + " still used by " + usersText(users)};
    }
    EditSheet sheet(loaded);
    for (const Chosen& c : all.value()) {
        const Part& part = *c.place.part;
        sheet.removeItem(part.range);
        if (part.block->name || c.place.above.empty()) continue;
        std::vector<const Part*> except;
        for (const Chosen& other : all.value()) except.push_back(other.place.part);
        keepNames(c.place.above.back()->parts, part.block->type.text, mentions, except, sheet);
    }
    return sheet.plan({});
}

} // namespace trundle
