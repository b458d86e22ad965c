#include "editor/shell/commands/file_commands.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMessageBox>
#include <QRegularExpression>

#include "editor/shell/recent_files.h"
#include "editor/shell/unsaved_files.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/resources.h"
#include "editor/widgets/save_question.h"

namespace trundle {
namespace {

constexpr qsizetype kMaxLines = 20;

/// One name per line.
QString linesOf(const QStringList& names) {
    QStringList lines = names.mid(0, kMaxLines);
    if (const auto more = names.size() - kMaxLines; more > 0) lines += FileCommands::tr("and %1 more").arg(more);
    return lines.join(QLatin1Char('\n'));
}

const char* const kFilter = QT_TRANSLATE_NOOP("trundle::FileCommands", "Trundle texts (*.sim *.txt);;All files (*)");

} // namespace

FileCommands::FileCommands(QWidget& window, Document& document, Actions& actions, QString configs)
    : QObject(&window), m_window(window), m_document(document), m_configs(std::move(configs)) {
    const auto on = [&](const char* id, auto what) { connect(&actions.at(id), &QAction::triggered, this, what); };
    on("file.newExperiment", [this] { newFrom("experiment"); });
    on("file.newRobot", [this] { newFrom("robot"); });
    on("file.newArena", [this] { newFrom("arena"); });
    on("file.newEmpty", [this] {
        if (confirmClose()) makeNew(QStringLiteral("experiment"), {});
    });
    on("file.open", [this] { choose(); });
    on("file.openSample", [this] { close(); }); // the Welcome page lists the samples
    on("file.save", [this] { save(); });
    on("file.saveAs", [this] { saveAs(); });
    on("file.close", [this] { close(); });
    connect(&m_document, &Document::opened, this, &FileCommands::endOpening);
}

void FileCommands::close() {
    if (confirmClose()) m_document.opening().close();
}

QMenu* FileCommands::makeRecentMenu() {
    auto* menu = new QMenu(tr("Open &Recent"), &m_window);
    menu->setObjectName(QStringLiteral("menu.recent"));
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        for (const QString& file : recentFiles())
            menu->addAction(withoutMnemonics(shownLine(QDir::toNativeSeparators(file).toStdString())), this,
                            [this, file] { open(file); });
        if (menu->isEmpty()) menu->addAction(tr("Nothing yet"))->setEnabled(false);
    });
    return menu;
}

bool FileCommands::open(const QString& path) {
    if (!confirmClose()) return false;
    m_document.opening().openLater(path.toStdString());
    showOpening(path);
    return true;
}

/// Opens a progress dialog after half a second. Cancelling it keeps the project that was open before.
void FileCommands::showOpening(const QString& path) {
    delete m_progress;
    m_progress = new QProgressDialog(tr("Opening %1…").arg(QFileInfo(path).fileName()), tr("Cancel"), 0, 0, &m_window);
    m_progress->setObjectName(QStringLiteral("opening"));
    m_progress->setWindowTitle(tr("Opening"));
    m_progress->setAttribute(Qt::WA_ShowWithoutActivating);
    m_progress->setMinimumDuration(500);
    m_progress->setValue(0); // starts the timer of the minimum duration
    connect(m_progress, &QProgressDialog::canceled, this, [this] {
        m_document.opening().cancel();
        m_window.activateWindow();
        m_progress->deleteLater();
    });
}

/// The window gets the keyboard back that the dialog took: not every platform does that. Deleted at once, since its timer may be due.
void FileCommands::endOpening() {
    // It may just have been shown, so that it is not active yet. No window has the focus while another program has it.
    const bool tookFocus = m_progress && m_progress->isVisible() && QGuiApplication::focusWindow();
    delete m_progress;
    if (tookFocus) m_window.activateWindow();
}

void FileCommands::reportNotOpened(const QString& path, const QString& reason) {
    delete m_progress; // it would cover the message
    const QString what = reason.contains(path) ? reason : QStringLiteral("%1: %2").arg(path, reason);
    report(tr("Not opened"), Error{Code::FileUnreadable, what.toStdString()});
}

void FileCommands::newFrom(const char* templateName) {
    if (!confirmClose()) return;
    QFile file(resourcePath(QStringLiteral("templates/%1.sim").arg(QLatin1String(templateName))));
    if (!file.open(QIODevice::ReadOnly)) {
        report(tr("The template is missing"), Error{Code::FileUnreadable, file.errorString().toStdString()});
        return;
    }
    makeNew(QLatin1String(templateName), file.readAll());
}

void FileCommands::makeNew(const QString& subject, const QByteArray& text) {
    const QString name = tr("untitled %1").arg(subject).replace(QLatin1Char(' '), QLatin1Char('_'));
    report(tr("The template could not be opened"),
           m_document.opening().openNew((name + QStringLiteral(".sim")).toStdString(), text.toStdString()));
}

void FileCommands::tryOut(const QString& path) {
    static const QRegularExpression config(QStringLiteral("^(Robot|Static)Config\\s+(\\w+)"),
                                           QRegularExpression::MultilineOption);
    QFile file(path);
    QRegularExpressionMatch plan;
    if (file.open(QIODevice::ReadOnly))
        for (auto at = config.globalMatch(QString::fromUtf8(file.readAll())); at.hasNext();)
            plan = at.next(); // the last config uses the others
    if (!plan.hasMatch()) {
        open(path);
        return;
    }
    if (!confirmClose()) return;
    const bool robot = plan.captured(1) == QStringLiteral("Robot");
    const QString text = QStringLiteral(
        "// %1, to look at and to drive: Run, then Drive with the Keyboard. Its plan is in the file imported for it.\n"
        "Tick = 0.01\n#import %2\n#import %3\n\nStatic arena { Config=%4 Pos=0,0,0 }\n"
        "Robot robot0 { Config=%5 Pos=0,0,0 HPR=0,0,0 }\n");
    const QString own = QDir(m_configs).relativeFilePath(path), name = plan.captured(2);
    makeNew(QFileInfo(path).completeBaseName(),
            (robot ? text.arg(name, QStringLiteral("arenas/open_floor.sim"), own, QStringLiteral("OpenFloor"), name)
                   : text.arg(name, own, QStringLiteral("robots/simple_robot.sim"), name, QStringLiteral("SimpleRobot")))
                .toUtf8());
}

void FileCommands::choose() {
    const QString start = m_document.isOpen() && !m_document.isNew() ? QFileInfo(QString::fromStdString(m_document.path())).path()
                                                                     : m_configs + QStringLiteral("/experiments");
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open"), start, tr(kFilter));
    if (!path.isEmpty()) open(path);
}

bool FileCommands::save() {
    m_flush();
    if (!m_document.isOpen()) return true;
    if (m_document.isNew() || m_document.texts().isSample(m_document.path())) return saveAs();
    const Status status = m_document.saving().save();
    report(tr("Not saved"), status);
    return status.ok();
}

bool FileCommands::saveAs() {
    m_flush();
    if (!m_document.isOpen()) return true;
    QString start = QString::fromStdString(m_document.path());
    if (m_document.isNew() || m_document.texts().isSample(m_document.path())) {
        start = documentsFolder() + QLatin1Char('/') + QFileInfo(start).fileName();
    }
    const QString path = askWhereToSave(&m_window, tr("Save As"), start, tr(kFilter), QStringLiteral("sim"));
    if (path.isEmpty()) return false;
    const Status status = m_document.saving().saveAs(path.toStdString());
    report(tr("Not saved"), status);
    if (status.ok()) addRecentFile(path);
    return status.ok();
}

bool FileCommands::confirmClose() {
    m_flush();
    const auto* asked = m_window.findChild<QMessageBox*>(QStringLiteral("shareQuestion"));
    if (asked && asked->isVisible()) return false; // what was typed waits for the answer
    if (!m_document.isOpen() || !m_document.texts().isModified()) return true;
    const QStringList names = unsavedFiles(m_document);
    QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                         names.size() == 1 ? tr("Save the changes in %1?").arg(names.front())
                                           : tr("Save the changes in these %1 files?").arg(names.size()),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    const QString lost = tr("Unsaved changes are lost otherwise.");
    question.setInformativeText(names.size() == 1 ? lost : linesOf(names) + QStringLiteral("\n\n") + lost);
    question.setDefaultButton(QMessageBox::Save);
    question.setObjectName(QStringLiteral("unsavedQuestion"));
    switch (question.exec()) {
    case QMessageBox::Save: return save();
    case QMessageBox::Discard: return true;
    default: return false;
    }
}

void FileCommands::report(const QString& title, const Status& status) {
    if (status.ok()) return;
    QMessageBox message(QMessageBox::Warning, title, QString::fromStdString(status.error().message), QMessageBox::Ok, &m_window);
    message.setObjectName(QStringLiteral("fileMessage"));
    message.exec();
}

} // namespace trundle
