#include "editor/shell/status_line.h"

#include <algorithm>

#include <QEvent>
#include <QRegularExpression>

#include "editor/shell/unsaved_files.h"
#include "editor/widgets/name_list.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kRefusalMs = 8000;
constexpr qsizetype kMaxUnsavedNamed = 3; ///< file names listed
constexpr int kLeastOfName = 12;          ///< characters of an elided file name
constexpr int kSpacing = 6;               ///< pixels between the labels of a QStatusBar
constexpr int kUnlimited = 1 << 20;       ///< pixels

QString painted(const QString& text, Ink which) {
    return QStringLiteral("<span style=\"color:%1\">%2</span>").arg(ink(which).name(), text.toHtmlEscaped());
}

/// Whether a block or a Param of the document has this name, so that it is not written in another way.
bool isNameIn(const Document& document, const QString& word) {
    const QRegularExpression declared(QStringLiteral("\\b[A-Z]\\w*\\s+%1\\b\\s*[{=]").arg(QRegularExpression::escape(word)));
    for (const std::string& file : document.texts().files())
        if (const auto text = document.texts().text(file); text && QString::fromStdString(*text).contains(declared)) return true;
    return false;
}

/// Messages of the core are parts of sentences: "there is no rover.arm".
QString asSentence(const Document& document, QString message) {
    static const QRegularExpression firstWord(QStringLiteral("^([a-z]+)(?=[ ,;:]|$)"));
    const QString word = firstWord.match(message).captured(1);
    if (!word.isEmpty() && !isNameIn(document, word)) message[0] = message[0].toUpper();
    return message;
}

} // namespace

StatusLine::StatusLine(QStatusBar& bar, Document& document, RunSession& session)
    : QObject(&bar), m_bar(bar), m_document(document), m_session(session), m_file(new QLabel), m_saved(new QLabel),
      m_problems(new QLabel), m_logs(new QLabel), m_remote(new QLabel), m_engine(new QLabel), m_run(new QLabel) {
    m_bar.setSizeGripEnabled(false);
    m_bar.installEventFilter(this);
    m_file->setObjectName(QStringLiteral("status.file"));
    m_saved->setObjectName(QStringLiteral("status.saved"));
    m_problems->setObjectName(QStringLiteral("status.problems"));
    m_logs->setObjectName(QStringLiteral("status.logs"));
    m_remote->setObjectName(QStringLiteral("status.remote"));
    m_engine->setObjectName(QStringLiteral("status.engine"));
    m_run->setObjectName(QStringLiteral("status.run"));
    for (QLabel* label : {m_saved, m_problems, m_logs, m_remote, m_engine}) label->setTextFormat(Qt::RichText);
    for (QLabel* label : {m_file, m_saved, m_problems, m_logs, m_remote}) {
        label->setContentsMargins(8, 2, 8, 2);
        m_bar.addWidget(label);
    }
    m_run->setContentsMargins(8, 2, 10, 2);
    m_run->setTextFormat(Qt::PlainText); // it may contain text of a module
    m_engine->setContentsMargins(8, 2, 8, 2);
    m_bar.addPermanentWidget(m_engine);
    m_bar.addPermanentWidget(m_run);
    for (QLabel* label : {m_file, m_saved, m_problems, m_logs, m_remote, m_engine, m_run})
        label->setMinimumWidth(1); // fit() chooses their texts
    for (QLabel* label : {m_problems, m_logs, m_remote}) {
        label->setCursor(Qt::PointingHandCursor);
        label->installEventFilter(this);
    }
    connect(&document, &Document::changed, this, [this] {
        if (!m_refused.isEmpty() && m_bar.currentMessage() == m_refused) m_bar.clearMessage();
        m_refused.clear();
        refresh();
    });
    connect(&document.texts(), &DocumentTexts::modifiedChanged, this, &StatusLine::refresh);
    connect(&session, &RunSession::stateChanged, this, &StatusLine::refresh);
    refresh();
}

void StatusLine::refuse(const QString& reason) {
    m_refused = asSentence(m_document, reason);
    m_bar.showMessage(m_refused, kRefusalMs);
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_bar && event->type() == QEvent::StyleChange) { // the texts contain colours of the theme
        refresh();
        showProblems();
    }
    if (watched == &m_bar && event->type() == QEvent::Resize) fit();
    if (watched == m_problems && event->type() == QEvent::MouseButtonRelease) Q_EMIT problemsRequested();
    if (watched == m_remote && event->type() == QEvent::MouseButtonRelease) Q_EMIT remoteRequested();
    if (watched == m_logs && event->type() == QEvent::MouseButtonRelease) Q_EMIT logsRequested();
    return QObject::eventFilter(watched, event);
}

void StatusLine::refresh() {
    if (!m_document.isOpen()) return; // only the bar is hidden; QStatusBar hides its labels itself while it shows a message
    m_file->setToolTip(QString::fromStdString(m_document.path()));
    m_unsaved = unsavedFiles(m_document);
    m_saved->setToolTip(m_unsaved.isEmpty()
                            ? tr("All files are saved")
                            : tr("Files with unsaved changes:") + QLatin1Char('\n') + m_unsaved.join(QLatin1Char('\n')));
    fit();
}

/// In a narrow window the folder of the logs is left out, then the engine, the names of unsaved files, then a part of the name of the file; the
/// tool tips have them whole.
void StatusLine::fit() {
    m_remote->setText(m_remoteText.isEmpty() ? QString() : painted(m_remoteText, Ink::Accent));
    showFile(kUnlimited);
    showSaved(true);
    showLogs(true);
    showEngine(true);
    const auto missing = [this] {
        int needed = 0;
        for (const QLabel* label : {m_file, m_saved, m_problems, m_logs, m_remote, m_engine, m_run})
            needed += label->sizeHint().width() + kSpacing;
        return needed - m_bar.width();
    };
    if (missing() > 0) showLogs(false);
    if (missing() > 0) showEngine(false);
    if (missing() > 0) showSaved(false);
    if (const int more = missing(); more > 0) {
        const QMargins margins = m_file->contentsMargins();
        showFile(m_file->sizeHint().width() - margins.left() - margins.right() - more);
    }
}

/// That of the run, else the one in the text, where auto is not decided before a run.
void StatusLine::showEngine(bool shown) {
    std::optional<EngineChoice> engine;
    if (const auto& snapshot = m_session.results().snapshot) engine = snapshot->engine;
    else if (const auto& valid = m_document.lastValid(); valid && valid->experiment) engine = valid->experiment->settings.engine;
    const auto& run = m_session.results().snapshot;
    QString text;
    if (engine && shown)
        text = *engine == EngineChoice::Wheeled  ? tr("wheeled engine")
               : *engine == EngineChoice::Planar ? tr("planar engine")
               : *engine == EngineChoice::Auto   ? tr("engine: auto")
                                                 : tr("general engine");
    if (!text.isEmpty() && run && run->threads > 1) text = tr("%1, %2 threads").arg(text, QString::number(run->threads));
    m_engine->setText(text.isEmpty() ? text : painted(text, Ink::Faint));
    m_engine->setToolTip(tr("Engine, of the experiment: what computes the motion"));
}

void StatusLine::showFile(int width) {
    const QString name = QString::fromStdString(m_document.texts().shown(m_document.path()));
    const int least = m_file->fontMetrics().averageCharWidth() * kLeastOfName;
    m_file->setText(m_file->fontMetrics().elidedText(name, Qt::ElideMiddle, std::max(width, least)));
}

void StatusLine::showSaved(bool names) {
    const qsizetype count = m_unsaved.size();
    if (count == 0) m_saved->setText(painted(tr("saved"), Ink::Faint));
    else if (m_document.isNew() && count == 1) m_saved->setText(painted(tr("not saved yet"), Ink::Warning));
    else if (names) m_saved->setText(painted(tr("unsaved: %1").arg(listed(m_unsaved, kMaxUnsavedNamed)), Ink::Warning));
    else m_saved->setText(painted(count == 1 ? tr("1 unsaved file") : tr("%1 unsaved files").arg(count), Ink::Warning));
}

void StatusLine::setRunText(const QString& text, const QString& tip) {
    m_run->setText(text);
    m_run->setToolTip(tip);
    fit();
}

void StatusLine::setLogs(const QString& folder) {
    m_logFolder = folder;
    fit();
}

void StatusLine::showLogs(bool whole) {
    const QString shown = QString::fromStdString(m_document.texts().shown(m_logFolder.toStdString()));
    m_logs->setText(m_logFolder.isEmpty() ? QString() : painted(whole ? tr("logs in %1").arg(shown) : tr("logs"), Ink::Accent));
    m_logs->setToolTip(m_logFolder.isEmpty() ? QString() : tr("Open %1").arg(m_logFolder));
}

void StatusLine::setRemote(const QString& text) {
    m_remoteText = text;
    m_remote->setToolTip(text.isEmpty() ? QString() : tr("Other programs can take part in the run: Remote Control"));
    fit();
}

void StatusLine::setProblems(int errors, int warnings) {
    m_errors = errors;
    m_warnings = warnings;
    showProblems();
    fit();
}

void StatusLine::showProblems() {
    const int count = m_errors + m_warnings;
    m_problems->setText(
        count == 0 ? painted(tr("no problems"), Ink::Faint)
                   : painted(count == 1 ? tr("1 problem") : tr("%1 problems").arg(count), m_errors ? Ink::Error : Ink::Warning));
}

} // namespace trundle
