#pragma once
// Plans what must be written so that a project means the same when its opened file is saved elsewhere. Private to
// editor/document.

#include <map>
#include <set>
#include <string>

#include "app/application.h"
#include "base/result.h"
#include "editor/document/document.h"

namespace trundle {

struct SavePlan {
    std::map<std::string, std::string> moves; ///< current path -> new path, including the opened file
    TextOverlay texts;                        ///< by the new path; imports and references rewritten where necessary
    /// Files other than texts: new path -> source. Without files that already exist there.
    std::map<std::string, std::string> copies;
    Companions companions;
};

/// `mustMove`: files that cannot be saved at their path. Nothing is written: the plan is checked on texts in memory. Fails if
/// a file would overwrite another.
[[nodiscard]] Result<SavePlan> planSaveAs(Application& application, const LoadedProject& loaded, OpenOptions options,
                                          const std::string& target, const std::set<std::string>& mustMove, ModuleCopies modules);

} // namespace trundle
