#pragma once
// Loads an experiment: its file, imports, modules and `--set` texts.

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/loading/loaded_project.h"
#include "project/loading/sources.h"
#include "project/loading/text_overlay.h"

namespace trundle {

struct ProjectOptions {
    std::vector<std::string> includeFolders; ///< import search folders (-I)
    std::string shippedConfigs;              ///< folder of the configs shipped with the program
    std::string resources;                   ///< folder of textures and meshes
    std::vector<std::string> sets;           ///< "robot0.leftMotor.Resistance=3", applied to an in-memory copy in order
    TextOverlay texts;                       ///< used instead of the files on disk
    /// An earlier load of the same file: trees with unchanged path, FileId and bytes are reused instead of parsed again.
    std::shared_ptr<const LoadedProject> previous;
    bool shownFromProject = false; ///< file names in messages are relative to the project's folder instead of the current folder
    /// Words, signs and blanks of all texts together; an experiment with more is an error. Bounds the memory for a text without mistakes.
    std::size_t mostTokens = 6'000'000;
};

class Project {
public:
    /// `builtIn` holds the kinds of model, devices and logs. `catalog` and `meshes` must outlive the project.
    Project(std::shared_ptr<const Registry> builtIn, ModuleCatalog& catalog, MeshSource& meshes, ProjectOptions options);

    /// Loads the file and everything it imports. Fails only if the file itself cannot be read. Thread-safe for concurrent loads.
    /// Stops reading a large file if its beginning has too many errors, or at the limit of the options.
    [[nodiscard]] Result<std::shared_ptr<const LoadedProject>> open(const std::string& path);

private:
    struct Attempt;
    [[nodiscard]] Result<Attempt> attempt(const std::string& path, std::size_t mostTokens,
                                          std::shared_ptr<const LoadedProject> previous);

    std::shared_ptr<const Registry> m_builtIn;
    ModuleCatalog& m_catalog;
    MeshSource& m_meshes;
    ProjectOptions m_options;
};

} // namespace trundle
