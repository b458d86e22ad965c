#pragma once
// Private state of Document, for the .cpp files of editor/document.

#include <memory>
#include <set>
#include <string>

#include "editor/document/disk_watch.h"
#include "editor/document/journal_writer.h"
#include "editor/document/project_reader.h"
#include "project/journal/project_lock.h"
#include "project/saving/open_files.h"

namespace trundle {

class StructureEdits;

struct DocumentState {
    explicit DocumentState(Application& application) : reader(application) {}

    OpenFiles files;
    std::string opened; ///< absolute path of the opened file; for a new text, its path in the text overlay
    std::string name;   ///< of a new text; "" once it is saved to a file
    std::set<std::string> reportedModified;
    DiskWatch watch;
    JournalWriter journal{files};
    std::unique_ptr<ProjectLock> lock;
    bool readOnly = false;
    bool readsNamed = false;                   ///< a worker thread reads meshes and images
    std::shared_ptr<StructureEdits> structure; ///< shared_ptr: its type is not known here
    ProjectReader reader;

    [[nodiscard]] bool isNew() const { return !name.empty(); }
};

} // namespace trundle
