#pragma once
// What the parts of a document share. Private to editor/document.

#include <cstdint>
#include <memory>
#include <string>

#include <QObject>

#include "editor/document/disk_watch.h"
#include "editor/document/history.h"
#include "editor/document/journal_writer.h"
#include "editor/document/project_reader.h"
#include "project/edits/change_set.h"
#include "project/journal/project_lock.h"
#include "project/saving/open_files.h"

namespace trundle {

/// Messages of the parts of a document to the user. The document passes them on.
class DocumentMessages final : public QObject {
    Q_OBJECT
Q_SIGNALS:
    void refused(const QString& reason); ///< an edit was refused
    void notice(const QString& text);    ///< information; no decision is needed
    void selectionRequested(const std::vector<std::string>& paths);
};

struct DocumentState {
    explicit DocumentState(Application& from) : application(from), reader(from) {}

    Application& application;
    OpenOptions options; ///< trusted modules and search folders
    OpenFiles files;
    std::string opened; ///< absolute path of the opened file; for a new text, its path in the text overlay
    std::string name;   ///< of a new text; "" once it is saved to a file
    std::shared_ptr<const LoadedProject> loaded, lastValid;
    ChangeSet changes; ///< of the last load, until it is notified
    History history;
    std::uint64_t revision = 0;
    DocumentMessages messages;
    DiskWatch watch;
    JournalWriter journal{files};
    ProjectReader reader;

    [[nodiscard]] bool isOpen() const { return loaded != nullptr; }
    [[nodiscard]] bool isNew() const { return !name.empty(); }
    [[nodiscard]] bool isSample(const std::string& file) const;
    [[nodiscard]] std::string shown(const std::string& file) const; ///< path for display
    [[nodiscard]] std::string journalFolder() const;
    Status report(Status status); ///< emits refused() if the status is a failure
    void updateWatchedFiles();
};

} // namespace trundle
