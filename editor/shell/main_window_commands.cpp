// MainWindow: implementation of its commands.

#include <utility>

#include <QApplication>
#include <QCloseEvent>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include "editor/cameras/cameras_panel.h"
#include "editor/cameras/movie_dialog.h"
#include "editor/outline/library_panel.h"
#include "editor/radios/radios_panel.h"
#include "editor/sensors/sensors_panel.h"
#include "editor/shell/commands/file_commands.h"
#include "editor/shell/main_window.h"
#include "editor/shell/saved_window_state.h"
#include "editor/shell/work_area.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/view/viewport_panel.h"
#include "editor/widgets/apply_theme.h"

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

void MainWindow::setLayout(Layout layout) {
    const Layout before = m_layouts->current();
    m_layouts->use(layout);
    m_work->changeLayout(before, layout);
}

/// Shows the Problems panel once after opening a file with diagnostics.
void MainWindow::raiseProblemsOnce() {
    if (!std::exchange(m_problemsMayCome, false) || !m_document->isOpen()) return;
    if (m_document->loaded()->diagnostics.errorCount() > 0) m_layouts->raise(QStringLiteral("problems"));
}

bool MainWindow::isSettled() const {
    return !m_document->opening().isOpening() && m_viewport->isSettled() && m_library->isSettled() && m_cameras->isSettled() &&
           m_radios->isSettled() && m_sensors->isSettled();
}

void MainWindow::showPlace(const std::string& file, TextRange range) {
    m_work->showText(true);
    m_text->reveal(file, range, true);
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
    if (event->type() == QEvent::ActivationChange && isActiveWindow()) m_document->disk().check();
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
    m_document->opening().close();
}

} // namespace trundle
