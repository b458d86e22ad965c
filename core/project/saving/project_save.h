#pragma once
#include <functional>
#include <string>
#include <vector>

#include "project/saving/open_files.h"

namespace trundle {

struct SavePlan;

/// What a save needs of the program that edits the files.
struct SaveEnvironment {
    std::vector<std::string> folders;                                            ///< whose files may be written, absolute
    std::function<bool(const std::string& path)> isSample;                       ///< installed with Trundle
    std::function<std::string(const std::string& path)> shown;                   ///< path for messages
    std::function<void(const std::string& path, SharedText)> loadExternalChange; ///< another program wrote these bytes
    std::function<void()> writeJournal;                                          ///< of all unsaved texts
};

/// One save of the modified files of a project. What it guarantees:
/// - All or none: where one file cannot be written, copied or removed, the others get their old bytes again, and the texts here
///   count as unsaved. The error gives the file and the reason.
/// - Each file is replaced atomically: another program, or a crash, sees its old bytes or the new ones.
/// - Nothing of another program is lost: the files are locked from the first check to the last write, and a file whose bytes on
///   disk were not loaded here is not written; they are loaded instead, so that the user sees them before the next save.
/// - Nothing outside the project is written, also where a path leads outside through a link made since, and no sample.
/// - No edit is lost if the process is killed: the journal holds all unsaved texts before the first byte is written.
/// - A save that is cut off leaves a project that opens: a file that an edit created is written before the files that import it,
///   and one that an undo removes is removed after them; Save As writes the importing file last.
class ProjectSave {
public:
    ProjectSave(OpenFiles& files, SaveEnvironment environment) : m_files(files), m_environment(std::move(environment)) {}

    /// Writes every modified file to its path.
    [[nodiscard]] Status save() { return save(m_files.modified()); }
    [[nodiscard]] Status save(const std::vector<std::string>& modified); ///< of the modified files, these
    /// Writes the files that move to their new paths, and all that the plan copies. If the opened file keeps its path, the other
    /// modified files are written too, except samples. The paths in `files` stay; see OpenFiles::rename().
    [[nodiscard]] Status saveAs(const SavePlan& plan);

private:
    using Paths = std::vector<std::string>;
    [[nodiscard]] Status checkWritable(const Paths& paths);
    [[nodiscard]] Status checkWritable(const std::string& path);
    [[nodiscard]] Status checkUnchanged(const std::string& path);
    [[nodiscard]] Status writeModified(const Paths& modified);
    [[nodiscard]] Status writeMoved(const SavePlan& plan, const Paths& staying);
    [[nodiscard]] Paths stayingFiles(const SavePlan& plan) const;
    void markSaved(const Paths& paths);

    OpenFiles& m_files;
    SaveEnvironment m_environment;
};

} // namespace trundle
