#include "lang/characters.h"
#include "lang/edit_style.h"
#include "model/dotted_path.h"
#include "project/edits/edit_builder.h"
#include "project/edits/moved_block.h"
#include "project/edits/pasted_blocks.h"
#include "project/edits/plan_copies.h"
#include "project/edits/plan_targets.h"
#include "project/objects/object_names.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

/// The chosen blocks as text, with the blocks that they are in.
Result<PastedBlocks> readBlocks(const LoadedProject& loaded, const std::vector<Chosen>& all) {
    std::string text;
    for (const Chosen& c : all) {
        const Part& part = *c.place.part;
        if (part.is(Role::Medium))
            return Error{Code::DuplicateName, part.title() + " cannot be doubled: an experiment has one radio medium"};
        if (!part.kind) return Error{Code::UnknownKind, part.title() + " is of a kind that is not loaded"};
        text += blockText(loaded, part.range) + "\n";
    }
    Result<PastedBlocks> blocks = PastedBlocks::read(*loaded.registry, text);
    if (!blocks.ok() || blocks.value().entries.size() != all.size())
        return Error{Code::UnexpectedText, "the text has errors here; fix them first"};
    for (std::size_t i = 0; i < all.size(); ++i)
        blocks.value().entries[i].target = all[i].place.above.empty() ? nullptr : all[i].place.above.back();
    return blocks;
}

std::string shiftedText(const LoadedProject& loaded, const Chosen& c, const Kind& kind, std::string text, const Vec3& offset) {
    MovedBlock block(std::move(text));
    if (offset == Vec3::Zero()) return block.text();
    if (kind.find("Pos")) block.shift("Pos", offset, poseAt(loaded, c.place).position);
    for (const char* key : {"Anchor", "Anchor2"}) {
        const auto anchor = kind.find(key) ? valueAt(loaded, c.place, key) : std::nullopt;
        if (anchor && anchor->numbers.size() == 3)
            block.shift(key, offset, {anchor->numbers[0], anchor->numbers[1], anchor->numbers[2]});
    }
    return block.text();
}

} // namespace

Result<EditPlan> planCopies(const LoadedProject& loaded, const std::vector<std::string>& paths,
                            const std::vector<Vec3>& offsets) {
    const Result<std::vector<Chosen>> all = chosen(loaded, paths);
    if (!all.ok()) return all.error();
    Result<PastedBlocks> read = readBlocks(loaded, all.value());
    if (!read.ok()) return read.error();
    PastedBlocks& copies = read.value();
    std::map<std::pair<const Part*, const NameSpace*>, UsedNames> names;
    EditBuilder sheet(loaded);
    std::vector<std::string> selects;
    for (const Vec3& offset : offsets) {
        for (std::size_t i = 0; i < all.value().size(); ++i) {
            PastedBlocks::Entry& copy = copies.entries[i];
            const NameSpace* space = copy.target ? nullptr : loaded.outline->spaceOf(*copy.kind);
            UsedNames& used = names.try_emplace({copy.target, space}, loaded, copy.target, copy.kind).first->second;
            copy.name = used.take(all.value()[i].place.part->name);
        }
        for (std::size_t i = 0; i < all.value().size(); ++i) {
            const Chosen& c = all.value()[i];
            const PastedBlocks::Entry& copy = copies.entries[i];
            const Part& part = *c.place.part;
            const std::string text = shiftedText(loaded, c, *copy.kind, copies.textOf(loaded, copy), offset);
            sheet.add(copyBehind(*loaded.trees[part.file], part.range.range, text));
            selects.push_back(pathInside(withoutLastWord(c.path), copy.name));
        }
    }
    return sheet.plan(std::move(selects));
}

Result<EditPlan> planDuplicate(const LoadedProject& loaded, const std::vector<std::string>& paths, const Vec3& offset) {
    return planCopies(loaded, paths, {offset});
}

} // namespace trundle
