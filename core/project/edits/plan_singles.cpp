#include "lang/edit_style.h"
#include "project/edits/edit_builder.h"
#include "project/edits/plan_targets.h"
#include "project/loading/members.h"
#include "project/objects/object_names.h"

namespace trundle {

Result<EditPlan> planReplaceBySingles(const LoadedProject& loaded, const std::string& path) {
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    const Part* layout = place ? place->instance : nullptr;
    if (!layout || !layout->is(Role::Layout)) return Error{Code::NoSuchPath, path + " is no Grid or Scatter"};
    if (!place->around.empty())
        return Error{Code::ReplaceBySingles,
                     path + " is in " + place->around.back()->title() + ": its members would be written once for all of that"};
    Diagnostics said;
    reportReplaceBySingles({layout, layout->name, layout->nameRange()}, *loaded.outline, *loaded.experiment, said);
    if (said.all().empty() || said.all()[0].fixes.empty())
        return Error{Code::ReplaceBySingles, layout->title() + " has no members that could be written out"};
    const TextEdit& edit = said.all()[0].fixes[0].edits.at(0);
    const Tree& tree = *loaded.trees[layout->file];
    const std::string lineEnd = editStyle(tree).lineEnd + indentOfLine(tree.source().bytes(), layout->range.range.begin);
    std::string text;
    for (const char c : dedented(edit.text)) text += c == '\n' ? lineEnd : std::string(1, c);
    EditBuilder sheet(loaded);
    sheet.add({edit.range, text});
    std::vector<std::string> selects;
    for (const RobotSpec& robot : loaded.experiment->robots)
        if (robot.range == layout->range && !robot.scenery) selects.push_back(robot.name);
    for (const StaticSpec& fixed : loaded.experiment->statics)
        if (fixed.range == layout->range) selects.push_back(fixed.name);
    return sheet.plan(std::move(selects));
}

bool canReplaceBySingles(const LoadedProject& loaded, const std::string& path) {
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    return place && place->instance && place->instance->is(Role::Layout) && place->around.empty();
}

std::string textOf(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    std::vector<std::string> there;
    for (const std::string& path : paths)
        if (requireChangeable(loaded, path).ok()) there.push_back(path);
    const Result<std::vector<Chosen>> all = chosen(loaded, there);
    if (!all.ok()) return {};
    std::string text;
    for (const Chosen& c : all.value())
        text += blockText(loaded, withOwnComments(loaded, c.place.part->range, rangesOf(all.value()))) + "\n";
    return text;
}

std::string freeName(const LoadedProject& loaded, const std::string& parent, const std::string& preferred) {
    const std::optional<ObjectLocation> place = placeOf(loaded, parent);
    const Part* part = place ? place->part : nullptr;
    if (part && part == place->instance)
        if (const Part* config = configOf(loaded, *part)) part = config;
    return UsedNames(loaded, part, nullptr).take(preferred);
}

} // namespace trundle
