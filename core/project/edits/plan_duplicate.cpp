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

namespace {

/// Inserts a copy after its original: on the same line if other items share that line, else on a line of its own, after a
/// trailing comment.
TextEdit behind(const Tree& tree, TextRange item, const std::string& text) {
    const std::string_view bytes = tree.source().bytes();
    const std::string indent = indentOfLine(bytes, item.begin);
    std::uint32_t start = item.begin;
    while (start > 0 && isBlank(bytes[start - 1])) --start;
    const bool first =
        start == 0 || bytes[start - 1] == '\n' || bytes[start - 1] == '\r' || (start == 3 && bytes.starts_with("\xEF\xBB\xBF"));
    std::uint32_t end = item.end;
    bool last = true;
    for (const Token& token : tree.tokens()) {
        if (token.range.begin < item.end || token.kind == TokenKind::Space) continue;
        if (token.kind == TokenKind::LineComment || token.kind == TokenKind::BlockComment) {
            end = token.range.end;
            continue;
        }
        last = token.kind == TokenKind::LineEnd || token.kind == TokenKind::End;
        break;
    }
    const bool lines = text.find('\n') != std::string::npos || text.find("//") != std::string::npos;
    if (!first && !lines) return {{tree.file(), {item.end, item.end}}, " " + text};
    const std::string lineEnd = editStyle(tree).lineEnd;
    std::string out = lineEnd + indent;
    for (const char c : text) out += c == '\n' ? lineEnd + indent : std::string(1, c);
    if (last) return {{tree.file(), {end, end}}, out};
    if (!lines) return {{tree.file(), {item.end, item.end}}, " " + text};
    return {{tree.file(), {item.end, item.end}}, out + lineEnd + indent};
}

} // namespace

Result<EditPlan> planDuplicate(const LoadedProject& loaded, const std::vector<std::string>& paths, const Vec3& offset) {
    const Result<std::vector<Chosen>> all = chosen(loaded, paths);
    if (!all.ok()) return all.error();
    std::string text;
    for (const Chosen& c : all.value()) {
        const Part& part = *c.place.part;
        if (part.is(Role::Controller))
            return Error{Code::MultipleControllers, part.title() + " cannot be doubled: a robot has one controller"};
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
            const auto anchor = copy.kind->find("Anchor") ? valueAt(loaded, c.place, "Anchor") : std::nullopt;
            if (anchor && anchor->numbers.size() == 3)
                block.shift("Anchor", offset, {anchor->numbers[0], anchor->numbers[1], anchor->numbers[2]});
        }
        const Part& part = *c.place.part;
        sheet.add(behind(*loaded.trees[part.file], part.range.range, block.text()));
        selects.push_back(pathInside(withoutLastWord(c.path), copy.name));
    }
    return sheet.plan(std::move(selects));
}

} // namespace trundle
