#pragma once
// A loaded experiment: the syntax trees of its files, the resolved specs and the diagnostics. Independent of the GUI.

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/platform/read_file.h"
#include "lang/source_text.h"
#include "lang/tree.h"
#include "model/experiment_spec.h"
#include "model/outline.h"
#include "model/set_targets.h"
#include "schema/registry.h"

namespace trundle {

class MeshShapes;

/// A mesh, image or table that a source file names.
struct NamedFile {
    std::string path; ///< absolute; "" if not found
    FileStamp stamp;  ///< taken before it was read; empty if not found
};

/// Result of one load. Immutable; every edit gives a new one.
struct LoadedProject {
    SourceTable sources;
    std::vector<std::shared_ptr<const Tree>> trees;   ///< by FileId; [0] is the opened file
    std::vector<std::string> paths;                   ///< absolute, by FileId; "" for a `--set` text
    std::shared_ptr<const ExperimentSpec> experiment; ///< never null; contains everything that could be resolved
    std::shared_ptr<const Registry> registry;         ///< built-in kinds and those of the loaded modules
    Diagnostics diagnostics;                          ///< in text order, without duplicates
    std::string projectFolder;
    std::vector<std::string> importFolders; ///< import search folders, used after the importing file's own folder
    std::string shippedConfigs;             ///< canonical; "" if unknown
    std::shared_ptr<const Outline> outline; ///< blocks by name, for provenance (model/provenance.h), navigation and edits
    std::vector<SetTarget> sets;            ///< targets of the options' sets; see project/loading/set_path.h
    /// By the file that names it and the path as written.
    std::map<std::pair<FileId, std::string>, NamedFile> named;
    std::shared_ptr<MeshShapes> shapes; ///< shapes computed from meshes; taken over from the previous load
    bool pending = false;               ///< some mesh or height map is not read yet; see OpenOptions::meshesLater
    std::size_t parses = 0;             ///< number of files parsed for this load; the other trees were reused
};

} // namespace trundle
