#pragma once
// Plans what must be written so that a project means the same when its opened file is saved elsewhere.

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "base/result.h"
#include "project/loading/loaded_project.h"
#include "project/loading/sources.h"
#include "project/loading/text_overlay.h"
#include "project/saving/companions.h"

namespace trundle {

struct SavePlan {
    std::string target;                       ///< new path of the opened file
    std::map<std::string, std::string> moves; ///< current path -> new path, including the opened file
    TextOverlay texts;                        ///< by the new path; imports and references rewritten where necessary
    /// Files other than texts: new path -> source. Without files that already exist there.
    std::map<std::string, std::string> copies;
    Companions companions;

    /// Whether the opened file keeps its path.
    [[nodiscard]] bool isInPlace() const { return moves.contains(target) && moves.at(target) == target; }
};

/// Where the plan looks up what a text refers to.
struct SavePlanSources {
    /// Loads the project from a file, with the current texts and these in place of the files on disk.
    std::function<Result<std::shared_ptr<const LoadedProject>>(const std::string& path, const TextOverlay& texts)> load;
    ModuleCatalog& modules; ///< finds modules in folders that are not trusted too
};

/// `mustMove`: files that cannot be saved at their path. Nothing is written: the plan is checked on texts in memory. Fails if
/// a file would overwrite another.
[[nodiscard]] Result<SavePlan> planSaveAs(const SavePlanSources& sources, const LoadedProject& loaded, const std::string& target,
                                          const std::set<std::string>& mustMove, ModuleCopies modules);

} // namespace trundle
