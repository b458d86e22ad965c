#pragma once
#include <memory>
#include <string>

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "editor/document/open_files.h"
#include "project/journal.h"

namespace trundle {

/// Keeps the journal of a document: half a second after an edit it is noted, and a thread waits for the disk.
class JournalKeeper final : public QObject {
    Q_OBJECT
public:
    explicit JournalKeeper(const OpenFiles& files, QObject* parent = nullptr);
    ~JournalKeeper() override;

    void start(const std::string& projectFolder, JournalHead head); ///< a journal of its own for what is open now
    void stop();                                                    ///< removes the journal: nothing of it is wanted any more
    void later();                                                   ///< some text is another one
    void writeNow();                                                ///< what is edited and not noted
    [[nodiscard]] std::string path() const;                         ///< of the journal's file; "" where there is none

Q_SIGNALS:
    /// Once until it can be written again.
    void failed(const QString& reason);

private:
    [[nodiscard]] Status write();

    const OpenFiles& m_files;
    std::unique_ptr<Journal> m_journal;
    QTimer m_timer;
    QThreadPool m_syncing;
    bool m_saidFailed = false;
};

} // namespace trundle
