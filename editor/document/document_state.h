#pragma once
// Private state of Document, for the .cpp files of editor/document.

#include <memory>
#include <set>
#include <string>

#include <QThreadPool>

#include "editor/document/disk_watch.h"
#include "editor/document/document.h"
#include "editor/document/journal_writer.h"
#include "editor/document/structure_edits.h"
#include "project/journal/project_lock.h"
#include "project/saving/open_files.h"

namespace trundle {

struct Document::State {
    OpenFiles files;
    std::string opened; ///< absolute path of the opened file; for a new text, its path in the text overlay
    std::string name;   ///< of a new text; "" once it is saved to a file
    std::set<std::string> reportedModified;
    DiskWatch watch;
    JournalWriter journal{files};
    std::unique_ptr<ProjectLock> lock;
    bool readOnly = false;
    bool readsNamed = false;    ///< a worker thread reads meshes and images
    std::uint64_t openings = 0; ///< number of the newest openLater() request
    std::unique_ptr<StructureEdits> structure;
    QThreadPool pool; ///< reads files; the last member: destroyed first, it waits for its threads

    [[nodiscard]] bool isNew() const { return !name.empty(); }
};

} // namespace trundle
