#pragma once
// An opened experiment: its files as trees, what they resolve to, and what is wrong with them. The edit loop with no GUI.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/platform/read_file.h"
#include "lang/source_text.h"
#include "lang/tree.h"
#include "model/experiment_spec.h"
#include "model/outline.h"
#include "model/set_targets.h"
#include "project/sources.h"
#include "project/text_overlay.h"
#include "schema/registry.h"

namespace trundle {

class MeshShapes;

struct Loaded;

struct ProjectOptions {
    std::vector<std::string> includeFolders; ///< -I
    std::string shippedConfigs;              ///< the program's own configs/
    std::string resources;                   ///< textures and meshes
    std::vector<std::string> sets;           ///< "robot0.leftMotor.Resistance=3", applied to an in-memory copy in order
    TextOverlay texts;                       ///< read instead of the files
    /// A former load of the same file: its trees whose path, FileId and bytes are the same are taken over, not parsed again.
    std::shared_ptr<const Loaded> previous;
    bool shownFromProject = false; ///< messages name files from the project's folder on, not from where the program stands
};

/// A mesh, a picture or a table that a text names.
struct NamedFile {
    std::string path; ///< absolute; "" where it was not found
    FileStamp stamp;  ///< before it was read; of nothing where it was not found
};

/// What one load gave. Immutable; a new edit gives a new one.
struct Loaded {
    SourceTable sources;
    std::vector<std::shared_ptr<const Tree>> trees;   ///< by FileId; [0] is the opened file
    std::vector<std::string> paths;                   ///< absolute, by FileId; "" for a `--set` text
    std::shared_ptr<const ExperimentSpec> experiment; ///< never null; what could be resolved
    std::shared_ptr<const Registry> registry;         ///< built-in kinds and those of the loaded modules
    Diagnostics diagnostics;                          ///< in the order of the text, each once
    std::string projectFolder;
    std::vector<std::string> importFolders; ///< in which imports are looked for after the importing file's own folder
    std::string shippedConfigs;             ///< canonical; "" where the program's own texts are not known
    std::shared_ptr<const Outline> outline; ///< what stands where: for provenance (model/provenance.h), navigation and edits
    std::vector<SetTarget> sets;            ///< where the options' sets lead; see project/set_path.h
    /// By the text that names them, and the words there.
    std::map<std::pair<FileId, std::string>, NamedFile> named;
    std::shared_ptr<MeshShapes> shapes; ///< what was worked out from meshes; a load takes over the previous one's
    bool pending = false;               ///< some mesh or height map is not read yet; see OpenOptions::meshesLater
    std::size_t parses = 0;             ///< texts that were parsed for this load; the others came from the previous one
};

class Project {
public:
    /// `builtIn` holds the kinds of model, devices and logs. catalog and meshes outlive the project.
    Project(std::shared_ptr<const Registry> builtIn, ModuleCatalog& catalog, MeshSource& meshes, ProjectOptions options);

    /// Reads the file and all it imports. Fails only when the file itself cannot be read. Touches nothing but its own parts: loads
    /// may go on in several threads. Of a large text that begins with mistakes alone the rest is not read.
    [[nodiscard]] Result<std::shared_ptr<const Loaded>> open(const std::string& path);

private:
    struct Attempt;
    [[nodiscard]] Result<Attempt> attempt(const std::string& path, std::size_t mostTokens,
                                          std::shared_ptr<const Loaded> previous);

    std::shared_ptr<const Registry> m_builtIn;
    ModuleCatalog& m_catalog;
    MeshSource& m_meshes;
    ProjectOptions m_options;
};

} // namespace trundle
