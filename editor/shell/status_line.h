#pragma once
#include <QLabel>
#include <QStatusBar>

#include "editor/document/document.h"

namespace trundle {

/// file • saved • problems • what the run says. A hint or a refusal takes the place on the left for a while.
class StatusLine final : public QObject {
    Q_OBJECT
public:
    StatusLine(QStatusBar& bar, Document& document);

    void setRunText(const QString& text) { m_run->setText(text); }
    /// Stands for some seconds, or until the document changes: what was refused may be possible then.
    void refuse(const QString& reason);
    /// Where the run writes its logs, to be clicked; empty: nowhere.
    void setLogs(const QString& folder);
    /// Of the texts and of the run, as the Problems panel lists them.
    void setProblems(int errors, int warnings);

Q_SIGNALS:
    void problemsWanted();
    void logsWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();

    QStatusBar& m_bar;
    Document& m_document;
    QLabel *m_file, *m_saved, *m_problems, *m_logs, *m_run;
    QString m_refused;
};

} // namespace trundle
