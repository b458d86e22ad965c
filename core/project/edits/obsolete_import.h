#pragma once
// Finds the import that a copy or the removal of a shipped definition makes obsolete. Private to core/project.

#include <optional>
#include <string>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

/// An import without which a project has what it uses, once `needed` is imported instead.
struct ObsoleteImport {
    const ImportItem* import = nullptr;
    SourceRange directive;
    std::vector<std::string> needed; ///< absolute paths of files that are still used and that only this import leads to
};

/// The import in the file `home` that leads to the file of a definition, if nothing in that file is used. Instances among `copied`
/// get a copy of the definition, and do not count.
[[nodiscard]] std::optional<ObsoleteImport> unusedImport(const LoadedProject& loaded, const Part& definition,
                                                         const std::vector<const Part*>& copied, FileId home);

/// The import in the file `home` that leads to a shipped config with errors or warnings, if all instances of the config are among
/// `copied`, which get a copy of it, and nothing else in its file is used: as long as the file is loaded, so are its errors.
[[nodiscard]] std::optional<ObsoleteImport> obsoleteImport(const LoadedProject& loaded, const Part& config,
                                                           const std::vector<const Part*>& copied, FileId home);

} // namespace trundle
