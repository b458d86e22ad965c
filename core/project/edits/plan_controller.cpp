#include <set>

#include "lang/edit_style.h"
#include "project/edits/edit_builder.h"
#include "project/edits/pasted_blocks.h"
#include "project/edits/plan_targets.h"
#include "project/loading/import_lines.h"
#include "project/objects/object_names.h"

namespace trundle {

namespace {

const Part* controllerOf(const Part& robot) {
    const auto it = std::find_if(robot.parts.begin(), robot.parts.end(), [](const Part& p) { return p.is(Role::Controller); });
    return it == robot.parts.end() ? nullptr : &*it;
}

/// Replaces a block, keeping its indent.
void replace(const LoadedProject& loaded, const Part& part, const std::string& text, EditBuilder& sheet) {
    const Tree& tree = *loaded.trees[part.file];
    const std::string lineEnd = editStyle(tree).lineEnd + indentOfLine(tree.source().bytes(), part.range.range.begin);
    std::string out;
    for (const char c : text) out += c == '\n' ? lineEnd : std::string(1, c);
    sheet.add({part.range, out});
}

} // namespace

Result<EditPlan> planController(const LoadedProject& loaded, const std::vector<std::string>& robots, const std::string& text,
                                const std::vector<std::string>& imports) {
    Result<PastedBlocks> read = PastedBlocks::read(*loaded.registry, text);
    if (!read.ok()) return read.error();
    PastedBlocks& blocks = read.value();
    if (blocks.entries.size() != 1 || (blocks.entries[0].kind && blocks.entries[0].kind->role != Role::Controller))
        return Error{Code::WrongPlace, "this is not one controller"};
    const Result<std::vector<Chosen>> all = chosen(loaded, robots);
    if (!all.ok()) return all.error();
    EditBuilder sheet(loaded);
    EditPlan done;
    std::set<FileId> files;
    for (const Chosen& c : all.value()) {
        const Part& robot = *c.place.part;
        if (!isPlaced(robot) || robot.block->type.text == "Static")
            return Error{Code::WrongPlace, robot.title() + " is no robot: it has no controller"};
        PastedBlocks::Entry& entry = blocks.entries[0];
        entry.target = &robot;
        const Part* before = controllerOf(robot);
        const std::string preferred = entry.block->name ? entry.block->name->text : before ? before->name : "brain";
        entry.name = before && before->name == preferred ? preferred : UsedNames(loaded, &robot, entry.kind).take(preferred);
        const std::string block = blocks.textOf(loaded, entry);
        if (before) replace(loaded, *before, block, sheet);
        else sheet.addItem(robot.file, robot.block, block);
        files.insert(robot.file);
        done.selects.push_back(c.path + "." + entry.name);
    }
    std::vector<std::string> lines = imports;
    lines.insert(lines.end(), blocks.directives.begin(), blocks.directives.end());
    for (const FileId file : files) {
        Result<std::vector<TextEdit>> edits = editsForImports(loaded, file, lines);
        if (!edits.ok()) return edits.error();
        for (TextEdit& edit : edits.value()) sheet.addFirst(std::move(edit));
    }
    return sheet.plan(std::move(done.selects));
}

} // namespace trundle
