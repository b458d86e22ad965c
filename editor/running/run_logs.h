#pragma once
#include <QObject>

#include "editor/document/document.h"
#include "run/logs/log_location.h"

namespace trundle {

/// Where the runs of the document write their logs.
class RunLogs final : public QObject {
    Q_OBJECT
public:
    /// `document` must outlive this object.
    explicit RunLogs(Document& document, QObject* parent = nullptr);
    ~RunLogs() override;

    /// The folder of a run that begins now; empty if it writes none. `hasLogs`: the experiment writes logs.
    [[nodiscard]] LogLocation begin(bool hasLogs);
    /// A run has written logs, perhaps only those that a controller opened.
    void written();
    /// Another document is open.
    void forget();
    /// The folder of the logs of this run or the last one; empty if it has none.
    [[nodiscard]] const QString& folder() const { return m_folder; }

Q_SIGNALS:
    void folderChanged();

private:
    [[nodiscard]] LogLocation location() const;
    void takeOwn(), dropOwn();
    void setFolder(const QString& folder);

    Document& m_document;
    QString m_folder;
    LogLocation m_own; // outside the project, for this experiment only
};

} // namespace trundle
