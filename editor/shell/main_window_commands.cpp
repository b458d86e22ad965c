// MainWindow: implementation of its commands.

#include <functional>
#include <utility>

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QDesktopServices>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QUrl>

#include "editor/cameras/cameras_panel.h"
#include "editor/cameras/movie_dialog.h"
#include "editor/document/found_journals.h"
#include "editor/outline/library_panel.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/outline_panel.h"
#include "editor/radios/radios_panel.h"
#include "editor/shell/command_palette.h"
#include "editor/shell/crash_reports.h"
#include "editor/shell/file_commands.h"
#include "editor/shell/help_panel.h"
#include "editor/shell/line_diff.h"
#include "editor/shell/main_window.h"
#include "editor/shell/recovery_dialog.h"
#include "editor/shell/saved_window_state.h"
#include "editor/shell/status_line.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/view/view.h"
#include "editor/viewport/view/viewport_panel.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

/// Whether no movie is being recorded, or the user agrees to cancel it.
bool confirmEndRecording(MainWindow& window) {
    const QPointer<MovieDialog> movie = window.findChild<MovieDialog*>();
    if (!movie || !movie->isRecording()) return true;
    QMessageBox question(QMessageBox::Question, MainWindow::tr("A movie is being recorded"),
                         MainWindow::tr("Stop recording and close the window?"), QMessageBox::NoButton, &window);
    question.setObjectName(QStringLiteral("movieQuestion"));
    question.setInformativeText(MainWindow::tr("The movie will be discarded."));
    question.addButton(MainWindow::tr("Stop Recording"), QMessageBox::DestructiveRole);
    QPushButton* stay = question.addButton(MainWindow::tr("Continue"), QMessageBox::RejectRole);
    question.setDefaultButton(stay);
    question.exec();
    return question.clickedButton() != stay || !movie || !movie->isRecording();
}

} // namespace

bool MainWindow::open(const QString& path) { return m_files->open(path); }

/// Of the block at the caret if a text has the focus, else of the selection.
const Kind* MainWindow::kindForHelp() {
    if (!m_document->isOpen() || !m_document->loaded() || m_help->hasFocus()) return nullptr;
    if (m_text->hasKeyboard()) return m_text->kindAtCaret();
    if (m_selection->empty()) return nullptr;
    const LoadedProject& loaded = *m_document->loaded();
    const std::string path = m_selection->current();
    if (path.empty()) return loaded.registry->find("settings");
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    if (!place) return nullptr;
    const Part* part = place->part ? place->part : place->instance;
    return part ? part->kind : nullptr;
}

void MainWindow::showHelp() {
    // Before the dock can take the focus.
    const QString construct = m_document->isOpen() && m_text->hasKeyboard() ? m_text->constructAtCaret() : QString();
    const Kind* kind = kindForHelp();
    m_layouts->raise(QStringLiteral("guide"));
    if (construct.isEmpty()) m_help->showKind(kind);
    else m_help->showConstruct(construct);
}

void MainWindow::showText(bool shown) {
    // At least one of the two is shown.
    if (!shown) m_viewport->show();
    const bool hadFocus = m_text->isAncestorOf(QApplication::focusWidget());
    m_text->setVisible(shown);
    if (!shown && hadFocus) m_viewport->current().setFocus(); // else a value of Properties would get the next keys
    m_actions->at("view.text").setChecked(shown);
    m_actions->at("view.viewport").setChecked(m_viewport->isVisibleTo(m_work));
}

void MainWindow::showViewport(bool shown) {
    if (!shown) m_text->show();
    m_viewport->setVisible(shown);
    m_actions->at("view.viewport").setChecked(shown);
    m_actions->at("view.text").setChecked(m_text->isVisibleTo(m_work));
}

void MainWindow::useView(const QString& name) {
    if (name.isEmpty()) return;
    if (name == QStringLiteral("text")) return showViewport(false);
    m_viewport->showView(name);
}

void MainWindow::setLayout(Layout layout) {
    const Layout before = m_layouts->current();
    if (before == Layout::Edit && layout == Layout::Run) m_textForEditing = m_text->isVisibleTo(m_work);
    m_layouts->use(layout);
    if (layout == before) return;
    showViewport(true);
    showText(layout == Layout::Edit && m_textForEditing);
}

void MainWindow::connectLogs() {
    QAction& open = m_actions->at("sim.openLogs");
    const auto show = [this, &open] {
        const QString& folder = m_session->logs().folder();
        open.setEnabled(!folder.isEmpty() && QFileInfo::exists(folder));
        m_status->setLogs(open.isEnabled() ? folder : QString());
    };
    connect(&m_session->logs(), &RunLogs::folderChanged, this, show);
    connect(m_session, &RunSession::stateChanged, this, show); // the folder is created with the first log
    connect(m_status, &StatusLine::logsRequested, &open, &QAction::trigger);
    connect(&open, &QAction::triggered, this, [this] {
        const QString& folder = m_session->logs().folder();
        if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
            m_status->refuse(tr("No file manager is available. The logs are in %1").arg(folder));
    });
    show();
}

/// Shows the Problems panel once after opening a file with diagnostics.
void MainWindow::raiseProblemsOnce() {
    if (!std::exchange(m_problemsMayCome, false) || !m_document->isOpen()) return;
    if (m_document->loaded()->diagnostics.errorCount() > 0) m_layouts->raise(QStringLiteral("problems"));
}

bool MainWindow::isSettled() const {
    return !m_document->isOpening() && m_viewport->isSettled() && m_library->isSettled() && m_cameras->isSettled() &&
           m_radios->isSettled();
}

void MainWindow::showPlace(const std::string& file, TextRange range) {
    showText(true);
    m_text->reveal(file, range, true);
}

/// Runs an edit action on the text that has the focus, else on the selected objects.
void MainWindow::doEdit(const char* id) {
    if (m_text->hasKeyboard() && m_text->apply(id)) return;
    const std::string_view what = id;
    if (what == "edit.cut") m_edits->cutSelected();
    else if (what == "edit.copy") m_edits->copySelected();
    else if (what == "edit.paste") m_edits->pasteAtSelected();
    else if (what == "edit.delete") m_edits->removeSelected();
    else if (what == "edit.duplicate") m_edits->duplicateSelected();
    else if (what == "edit.rename") {
        m_layouts->raise(QStringLiteral("scene"));
        m_outline->renameSelected();
    } else if (what == "edit.selectAll") {
        std::vector<std::string> all;
        for (const RobotSpec& robot : m_document->loaded()->experiment->robots) all.push_back(robot.name);
        for (const StaticSpec& still : m_document->loaded()->experiment->statics) all.push_back(still.name);
        m_selection->set(all);
    } else if (what == "edit.find") {
        showText(true);
        m_text->apply(id);
    }
}

QList<QAction*> MainWindow::insertActions() {
    QList<QAction*> leaves;
    QMenu* insert = m_menus.at(QStringLiteral("Insert"));
    Q_EMIT insert->aboutToShow();
    // Follows the menus rather than findChildren(), which would include actions just removed by aboutToShow().
    const std::function<void(const QMenu&)> collect = [&](const QMenu& menu) {
        for (QAction* action : menu.actions()) {
            if (action->menu()) collect(*action->menu());
            else if (action->objectName().startsWith(QStringLiteral("insert."))) leaves.append(action);
        }
    };
    collect(*insert);
    return leaves;
}

void MainWindow::showUndo() {
    const History& history = m_document->history();
    QAction &undo = m_actions->at("edit.undo"), &redo = m_actions->at("edit.redo");
    undo.setEnabled(history.canUndo());
    redo.setEnabled(history.canRedo());
    undo.setText(history.canUndo() ? tr("&Undo %1").arg(withoutMnemonics(history.entries()[history.position() - 1].name))
                                   : tr("&Undo"));
    redo.setText(history.canRedo() ? tr("&Redo %1").arg(withoutMnemonics(history.entries()[history.position()].name))
                                   : tr("&Redo"));
}

void MainWindow::setDarkTheme(bool dark) {
    Preferences now = loadPreferences();
    now.theme = dark ? ThemeChoice::Dark : ThemeChoice::Light;
    savePreferences(now);
    applyTheme(*qApp, themeOf(now.theme), now.fonts);
}

void MainWindow::applyPreferences(const Preferences& before, const Preferences& now) {
    const bool newTheme = now.theme != before.theme; // else the theme of the command line stays
    if (newTheme || now.fonts != before.fonts) applyTheme(*qApp, newTheme ? themeOf(now.theme) : currentTheme(), now.fonts);
    m_actions->at("view.theme").setChecked(currentTheme() == ThemeKind::Dark);
    m_text->setWrapLines(now.wrapLines);
    m_viewport->settings().setNavigation(now.navigation);
}

void MainWindow::offerRecovery() {
    if (m_document->isReadOnly()) return; // offered when it becomes editable
    for (const auto* report : findChildren<QMessageBox*>(QStringLiteral("crashReport")))
        if (report->isVisible()) return; // offered when it is closed
    reportJournals();
    std::vector<Recovery> found = m_document->recoveries();
    if (found.empty()) return;
    for (auto* asked : findChildren<RecoveryDialog*>()) asked->close(); // the new dialog includes their content
    auto* dialog = new RecoveryDialog(
        *m_document, std::move(found), [this] { return m_files->confirmClose(); }, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::showCrashReports(const QString& folder) {
    const QString text = takeCrashReports(folder);
    if (text.isEmpty()) return;
    auto* message = new QMessageBox(QMessageBox::Warning, tr("Trundle closed unexpectedly"), text, QMessageBox::Ok, this);
    message->setObjectName(QStringLiteral("crashReport"));
    message->setInformativeText(
        tr("Logs were written up to that moment. Unsaved edits are offered when their file is opened again."));
    message->setAttribute(Qt::WA_DeleteOnClose);
    connect(message, &QDialog::finished, this, &MainWindow::offerRecovery, Qt::QueuedConnection);
    message->open();
}

/// Reports each message once.
void MainWindow::reportJournals() {
    const QString text = journalsNotRead(*m_document);
    if (text.isEmpty() || text == std::exchange(m_reportedJournals, text)) return;
    auto* message = new QMessageBox(QMessageBox::Information, tr("Unsaved edits were not restored"), text, QMessageBox::Ok, this);
    message->setObjectName(QStringLiteral("journalsNotRead"));
    message->setAttribute(Qt::WA_DeleteOnClose);
    message->open();
}

void MainWindow::showReadOnly(const QString& holder) {
    for (auto* asked : findChildren<QMessageBox*>(QStringLiteral("lockQuestion"))) asked->close(); // the question is obsolete
    if (holder.isEmpty()) {
        QMetaObject::invokeMethod(this, &MainWindow::offerRecovery, Qt::QueuedConnection); // those of the other window
        return;
    }
    auto* question = new QMessageBox(QMessageBox::Information, tr("Open elsewhere"),
                                     tr("This project is open in %1.").arg(holder), QMessageBox::NoButton, this);
    question->setObjectName(QStringLiteral("lockQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setInformativeText(tr("It can be viewed and run here, but not edited."));
    question->setEscapeButton(question->addButton(tr("Open Read-Only"), QMessageBox::AcceptRole));
    const auto* edit = question->addButton(tr("Edit Anyway"), QMessageBox::DestructiveRole);
    connect(question, &QMessageBox::buttonClicked, this, [this, edit](QAbstractButton* button) {
        if (button == edit) m_document->editAnyway();
    });
    question->open();
}

void MainWindow::askAboutDiskChange(const QString& file) {
    const auto mineNow = m_document->text(file.toStdString()), theirs = m_document->diskChanges()[file.toStdString()];
    if (!mineNow || !theirs) return;
    for (auto* asked : findChildren<QMessageBox*>(QStringLiteral("diskQuestion")))
        if (asked->property("file") == file) delete asked; // the file changed again meanwhile
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Changed on disk"),
                        tr("Another program changed %1, which has unsaved edits here, and both change the same lines.")
                            .arg(QString::fromStdString(m_document->shown(file.toStdString()))),
                        QMessageBox::NoButton, this);
    question->setObjectName(QStringLiteral("diskQuestion"));
    question->setProperty("file", file);
    question->setAttribute(Qt::WA_DeleteOnClose);
    setHtmlInformation(*question, tr("Loading it from disk would change this; it can be undone.") +
                                      diffAsHtml(inShort(diffLines(*mineNow, *theirs, 1))));
    QPushButton* mine = question->addButton(tr("Keep My Version"), QMessageBox::RejectRole);
    question->setDefaultButton(mine);
    question->addButton(tr("Load From Disk"), QMessageBox::AcceptRole);
    connect(question, &QMessageBox::buttonClicked, this, [this, file, mine](QAbstractButton* button) {
        (void)m_document->resolveDiskChange(file.toStdString(),
                                            button == mine ? Document::Resolution::Mine : Document::Resolution::Theirs);
    });
    question->open();
}

void MainWindow::openPalette() {
    std::vector<CommandPalette::Command> more;
    for (QAction* action : insertActions())
        more.push_back({tr("Insert %1").arg(action->text().remove(QLatin1Char('&'))), tr("Insert"), action});
    for (QAction* action : m_layouts->raising()) more.push_back({action->text(), tr("View"), action});
    auto* palette = new CommandPalette(*m_actions, std::move(more), this);
    palette->setAttribute(Qt::WA_DeleteOnClose);
    palette->show();
}

void MainWindow::showAbout() {
    QMessageBox about(this);
    about.setObjectName(QStringLiteral("about"));
    about.setWindowTitle(tr("About Trundle"));
    about.setTextFormat(Qt::RichText);
    about.setText(tr("<p style='font-size:%1px; font-weight:600'>Trundle %2</p>")
                      .arg(QString::number(scaledToFont(18)), QApplication::applicationVersion()));
    setHtmlInformation(
        about,
        tr("<p>Describe robots, run them in 3D, measure, repeat.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later. The headers for controllers "
           "(<i>core/sdk</i>) are under the 2-clause BSD licence.</p>"
           "<p>With Qt %1, QScintilla, the Open Dynamics Engine, OpenSceneGraph, assimp and Eigen. Fonts: Inter and JetBrains "
           "Mono, SIL Open Font License.</p>"
           "<p>Implements and extends the simulator of James Ashcraft’s thesis <i>Design and Development of an Expandable "
           "Robot Simulation Framework</i> (2011).</p>")
            .arg(QLatin1String(qVersion())));
    about.exec();
}

/// The Delete and Cut shortcuts apply to objects only if the outline or a viewport has the focus. Elsewhere they belong to the
/// focused widget, and the selected robot stays.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const QKeySequence pressed(key.keyCombination());
        if (pressed == m_actions->at("edit.delete").shortcut() || pressed == m_actions->at("edit.cut").shortcut()) {
            event->accept();
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    // Another program may have changed a file while the window was inactive.
    if (event->type() == QEvent::ActivationChange && isActiveWindow()) m_document->checkExternalChanges();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!confirmEndRecording(*this) || !m_files->confirmClose()) return event->ignore();
    putAway();
    event->accept();
}

void MainWindow::rememberViews() {
    m_memory->start();
    m_viewport->settings().keepBetweenStarts();
}

void MainWindow::disableSettings() {
    m_savesSettings = false;
    m_layouts->disableSettings();
}

void MainWindow::putAway() {
    m_layouts->save();
    if (m_savesSettings) QSettings().setValue(QStringLiteral("windowGeometry"), saveGeometry());
    m_document->close();
}

} // namespace trundle
