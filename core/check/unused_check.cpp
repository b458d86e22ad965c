#include <algorithm>
#include <set>

#include "check/checks.h"
#include "project/edits/plans.h"
#include "project/objects/name_references.h"

namespace trundle {

/// Materials and surfaces of one file alone: an imported file is there for other experiments too, and so is one with nothing but them.
void checkUnused(const LoadedProject& loaded, FileId file, Diagnostics& diagnostics) {
    if (file >= loaded.trees.size()) return;
    const auto isOther = [&](const Item& item) {
        const auto* block = item.as<BlockItem>();
        return block && (block->type.text.ends_with("Config") || block->type.text == "Robot" || block->type.text == "Static");
    };
    if (std::ranges::none_of(loaded.trees[file]->items(), isOther)) return;
    std::set<const BlockItem*> used;
    for (const NameReference& reference : referencesIn(loaded)) used.insert(reference.target);
    for (const Item& item : loaded.trees[file]->items()) {
        const auto* block = item.as<BlockItem>();
        if (!block || !block->name || (block->type.text != "Material" && block->type.text != "Surface")) continue;
        if (used.contains(block)) continue;
        Diagnostic& d = diagnostics.hint(Code::UnusedDefinition, {file, block->name->range},
                                         block->type.text + " " + block->name->text + " is not used");
        const Result<EditPlan> plan = planRemove(loaded, {block->type.text + "." + block->name->text});
        if (plan.ok() && plan.value().edits.size() == 1) d.fixes.push_back({"remove it", plan.value().edits.begin()->second});
    }
}

} // namespace trundle
