#pragma once
// What a Document keeps to itself. Private to editor/document.

#include <memory>
#include <set>
#include <string>

#include <QThreadPool>

#include "editor/document/disk_watch.h"
#include "editor/document/document.h"
#include "editor/document/journal_keeper.h"
#include "editor/document/open_files.h"
#include "editor/document/structure_edits.h"
#include "project/project_lock.h"

namespace trundle {

struct Document::State {
    OpenFiles files;
    std::string opened; ///< absolute path of the opened file; of a new text, the one it has in the overlay
    std::string name;   ///< of a new text; "" once a file holds it
    std::set<std::string> saidModified;
    DiskWatch watch;
    JournalKeeper journal{files};
    std::unique_ptr<ProjectLock> lock;
    bool readOnly = false;
    bool readsNamed = false;    ///< a thread reads meshes and pictures
    std::uint64_t openings = 0; ///< which openLater() is the newest
    std::unique_ptr<StructureEdits> structure;
    QThreadPool pool; ///< reads files; the last member, so that it ends first

    [[nodiscard]] bool isNew() const { return !name.empty(); }
};

} // namespace trundle
