#include "editor/shell/status_line.h"

#include <QEvent>

#include "editor/shell/unsaved_files.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kRefusalMs = 8000;
constexpr qsizetype kMaxUnsavedNamed = 3; ///< file names listed

QString painted(const QString& text, Ink which) {
    return QStringLiteral("<span style=\"color:%1\">%2</span>").arg(ink(which).name(), text.toHtmlEscaped());
}

} // namespace

StatusLine::StatusLine(QStatusBar& bar, Document& document)
    : QObject(&bar), m_bar(bar), m_document(document), m_file(new QLabel), m_saved(new QLabel), m_problems(new QLabel),
      m_logs(new QLabel), m_run(new QLabel) {
    m_bar.setSizeGripEnabled(false);
    m_bar.installEventFilter(this);
    m_file->setObjectName(QStringLiteral("status.file"));
    m_saved->setObjectName(QStringLiteral("status.saved"));
    m_problems->setObjectName(QStringLiteral("status.problems"));
    m_logs->setObjectName(QStringLiteral("status.logs"));
    m_run->setObjectName(QStringLiteral("status.run"));
    for (QLabel* label : {m_saved, m_problems, m_logs}) label->setTextFormat(Qt::RichText);
    for (QLabel* label : {m_file, m_saved, m_problems, m_logs}) {
        label->setContentsMargins(8, 2, 8, 2);
        m_bar.addWidget(label);
    }
    m_run->setContentsMargins(8, 2, 10, 2);
    m_run->setTextFormat(Qt::PlainText); // it may contain text of a module
    m_bar.addPermanentWidget(m_run);
    for (QLabel* label : {m_problems, m_logs}) {
        label->setCursor(Qt::PointingHandCursor);
        label->installEventFilter(this);
    }
    connect(&document, &Document::changed, this, [this] {
        if (!m_refused.isEmpty() && m_bar.currentMessage() == m_refused) m_bar.clearMessage();
        m_refused.clear();
        refresh();
    });
    connect(&document.texts(), &DocumentTexts::modifiedChanged, this, &StatusLine::refresh);
    refresh();
}

void StatusLine::refuse(const QString& reason) {
    m_refused = reason;
    m_bar.showMessage(reason, kRefusalMs);
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_bar && event->type() == QEvent::StyleChange) { // the texts contain colours of the theme
        refresh();
        showLogs();
        showProblems();
    }
    if (watched == m_problems && event->type() == QEvent::MouseButtonRelease) Q_EMIT problemsRequested();
    if (watched == m_logs && event->type() == QEvent::MouseButtonRelease) Q_EMIT logsRequested();
    return QObject::eventFilter(watched, event);
}

void StatusLine::refresh() {
    if (!m_document.isOpen()) return; // only the bar is hidden; QStatusBar hides its labels itself while it shows a message
    m_file->setText(QString::fromStdString(m_document.texts().shown(m_document.path())));
    m_file->setToolTip(QString::fromStdString(m_document.path()));
    const QStringList unsaved = unsavedFiles(m_document);
    m_saved->setText(unsaved.isEmpty() ? painted(tr("saved"), Ink::Faint)
                     : m_document.isNew() && unsaved.size() == 1
                         ? painted(tr("not saved yet"), Ink::Warning)
                         : painted(tr("unsaved: %1").arg(listed(unsaved, kMaxUnsavedNamed)), Ink::Warning));
    m_saved->setToolTip(unsaved.isEmpty()
                            ? tr("All files are saved")
                            : tr("Files with unsaved changes:") + QLatin1Char('\n') + unsaved.join(QLatin1Char('\n')));
}

void StatusLine::setLogs(const QString& folder) {
    m_logFolder = folder;
    showLogs();
}

void StatusLine::showLogs() {
    const QString shown = QString::fromStdString(m_document.texts().shown(m_logFolder.toStdString()));
    m_logs->setText(m_logFolder.isEmpty() ? QString() : painted(tr("logs in %1").arg(shown), Ink::Accent));
    m_logs->setToolTip(m_logFolder.isEmpty() ? QString() : tr("Open %1").arg(m_logFolder));
}

void StatusLine::setProblems(int errors, int warnings) {
    m_errors = errors;
    m_warnings = warnings;
    showProblems();
}

void StatusLine::showProblems() {
    const int count = m_errors + m_warnings;
    m_problems->setText(
        count == 0 ? painted(tr("no problems"), Ink::Faint)
                   : painted(count == 1 ? tr("1 problem") : tr("%1 problems").arg(count), m_errors ? Ink::Error : Ink::Warning));
}

} // namespace trundle
