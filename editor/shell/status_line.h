#pragma once
#include <QLabel>
#include <QStatusBar>

#include "editor/document/document.h"
#include "editor/running/session.h"

namespace trundle {

/// file • saved • problems • engine • run status. A hint or the reason of a refused action is shown temporarily on the left.
class StatusLine final : public QObject {
    Q_OBJECT
public:
    StatusLine(QStatusBar& bar, Document& document, RunSession& session);

    void setRunText(const QString& text, const QString& tip);
    /// Shown for some seconds or until the document changes, since the action may be possible then.
    void refuse(const QString& reason);
    /// Shows a link to the folder of the run's logs; empty: none.
    void setLogs(const QString& folder);
    /// Shows whether other programs take part in the run; empty: they cannot.
    void setRemote(const QString& text);
    /// Totals of the texts and of the run, as in the Problems panel.
    void setProblems(int errors, int warnings);

Q_SIGNALS:
    void problemsRequested();
    void logsRequested();
    void remoteRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void showFile(int width);
    void showSaved(bool names);
    void showLogs(bool whole);
    void showProblems();
    void showEngine(bool shown);
    void fit();

    QStatusBar& m_bar;
    Document& m_document;
    RunSession& m_session;
    QLabel *m_file, *m_saved, *m_problems, *m_logs, *m_remote, *m_engine, *m_run;
    QString m_refused, m_logFolder, m_remoteText;
    QStringList m_unsaved;
    int m_errors = 0, m_warnings = 0;
};

} // namespace trundle
