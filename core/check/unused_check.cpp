#include <set>

#include "check/checks.h"
#include "project/edits/plans.h"
#include "project/objects/name_references.h"

namespace trundle {

/// Materials and surfaces of the opened file alone: an imported file is there for other experiments too.
void checkUnused(const LoadedProject& loaded, Diagnostics& diagnostics) {
    const ExperimentSpec& experiment = *loaded.experiment;
    if (experiment.robots.empty() && experiment.statics.empty()) return; // definitions for others
    std::set<const BlockItem*> used;
    for (const NameReference& reference : referencesIn(loaded)) used.insert(reference.target);
    for (const Item& item : loaded.trees[0]->items()) {
        const auto* block = item.as<BlockItem>();
        if (!block || !block->name || (block->type.text != "Material" && block->type.text != "Surface")) continue;
        if (used.contains(block)) continue;
        Diagnostic& d = diagnostics.hint(Code::UnusedDefinition, {0, block->name->range},
                                         block->type.text + " " + block->name->text + " is not used");
        const Result<EditPlan> plan = planRemove(loaded, {block->type.text + "." + block->name->text});
        if (plan.ok() && plan.value().edits.size() == 1) d.fixes.push_back({"remove it", plan.value().edits.begin()->second});
    }
}

} // namespace trundle
