#pragma once
#include <memory>
#include <string>

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "project/journal/journal.h"
#include "project/saving/open_files.h"

namespace trundle {

/// Keeps the recovery journal of a document: an edit is written after half a second, and a worker thread syncs the file to
/// disk.
class JournalWriter final : public QObject {
    Q_OBJECT
public:
    explicit JournalWriter(const OpenFiles& files, QObject* parent = nullptr);
    ~JournalWriter() override;

    void start(const std::string& projectFolder, JournalHead head); ///< starts a new journal for the project that is open now
    void stop();                                                    ///< removes the journal: there is nothing to restore
    void later();                                                   ///< schedules a write after a text changed
    void writeNow();                                                ///< writes pending edits at once
    [[nodiscard]] std::string path() const;                         ///< path of the journal; "" if there is none

Q_SIGNALS:
    /// Emitted once per failure, again only after a successful write.
    void failed(const QString& reason);

private:
    [[nodiscard]] Status write();

    const OpenFiles& m_files;
    std::unique_ptr<Journal> m_journal;
    QTimer m_timer;
    QThreadPool m_syncing;
    bool m_reportedFailure = false;
};

} // namespace trundle
