#include "lang/characters.h"
#include "lang/edit_style.h"
#include "model/dotted_path.h"
#include "project/edits/edit_builder.h"
#include "project/edits/moved_block.h"
#include "project/edits/pasted_blocks.h"
#include "project/edits/plan_targets.h"
#include "project/objects/object_names.h"
#include "project/objects/part_values.h"

namespace trundle {

Result<EditPlan> planDuplicate(const LoadedProject& loaded, const std::vector<std::string>& paths, const Vec3& offset) {
    const Result<std::vector<Chosen>> all = chosen(loaded, paths);
    if (!all.ok()) return all.error();
    std::string text;
    for (const Chosen& c : all.value()) {
        const Part& part = *c.place.part;
        if (part.is(Role::Medium))
            return Error{Code::DuplicateName, part.title() + " cannot be doubled: an experiment has one radio medium"};
        if (!part.kind) return Error{Code::UnknownKind, part.title() + " is of a kind that is not loaded"};
        text += blockText(loaded, part.range) + "\n";
    }
    Result<PastedBlocks> read = PastedBlocks::read(*loaded.registry, text);
    if (!read.ok() || read.value().entries.size() != all.value().size())
        return Error{Code::UnexpectedText, "the text has errors here; fix them first"};
    PastedBlocks& copies = read.value();
    std::map<std::pair<const Part*, const NameSpace*>, UsedNames> names;
    for (std::size_t i = 0; i < all.value().size(); ++i) {
        const ObjectLocation& place = all.value()[i].place;
        PastedBlocks::Entry& copy = copies.entries[i];
        copy.target = place.above.empty() ? nullptr : place.above.back();
        const NameSpace* space = copy.target ? nullptr : loaded.outline->spaceOf(*copy.kind);
        copy.name = names.try_emplace({copy.target, space}, loaded, copy.target, copy.kind).first->second.take(place.part->name);
    }
    EditBuilder sheet(loaded);
    std::vector<std::string> selects;
    for (std::size_t i = 0; i < all.value().size(); ++i) {
        const Chosen& c = all.value()[i];
        const PastedBlocks::Entry& copy = copies.entries[i];
        MovedBlock block(copies.textOf(loaded, copy));
        if (offset != Vec3::Zero()) {
            if (copy.kind->find("Pos")) block.shift("Pos", offset, poseAt(loaded, c.place).position);
            for (const char* key : {"Anchor", "Anchor2"}) {
                const auto anchor = copy.kind->find(key) ? valueAt(loaded, c.place, key) : std::nullopt;
                if (anchor && anchor->numbers.size() == 3)
                    block.shift(key, offset, {anchor->numbers[0], anchor->numbers[1], anchor->numbers[2]});
            }
        }
        const Part& part = *c.place.part;
        sheet.add(copyBehind(*loaded.trees[part.file], part.range.range, block.text()));
        selects.push_back(pathInside(withoutLastWord(c.path), copy.name));
    }
    return sheet.plan(std::move(selects));
}

} // namespace trundle
