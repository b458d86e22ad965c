#include "editor/shell/commands/run_commands.h"

#include <algorithm>

#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

#include "editor/document/selection.h"
#include "editor/problems/problems_panel.h"
#include "editor/running/panels/keyboard_drive.h"
#include "editor/running/session.h"
#include "editor/shell/layouts.h"
#include "editor/shell/status_line.h"
#include "editor/viewport/view/viewport_panel.h"

namespace trundle {

RunCommands::RunCommands(QWidget& window, Actions& actions, const Targets& targets)
    : QObject(&window), m_actions(actions), m_targets(targets) {
    const RunMessages& messages = m_targets.session.messages();
    connect(&messages, &RunMessages::refused, &m_targets.status, &StatusLine::refuse);
    connect(&messages, &RunMessages::refused, this, [this] { m_targets.layouts.raise(QStringLiteral("problems")); });
    connect(&messages, &RunMessages::problemsChanged, this, &RunCommands::showMessages);
    connect(&m_targets.session, &RunSession::ended, this, &RunCommands::showEnd);
    connectLogs();
    connectDriving(window);
    connectRemote(window);
}

void RunCommands::showMessages() {
    const RunSession& session = m_targets.session;
    if (!session.results().built) return m_targets.problems.clearRunProblems();
    const ProblemsInCode shown = session.messages().problemsInCode(session.results().built);
    m_targets.problems.setRunProblems(shown.problems, shown.texts);
}

/// Selects the body that ended the run.
void RunCommands::showEnd() {
    m_targets.layouts.raise(QStringLiteral("problems"));
    const auto& end = m_targets.session.results().end;
    if (!end || end->body.empty()) return;
    std::string body = end->body;
    std::ranges::replace(body, '/', '.');
    m_targets.selection.select(body);
}

void RunCommands::connectLogs() {
    connect(&m_targets.session.logs(), &RunLogs::folderChanged, this, &RunCommands::showLogs);
    connect(&m_targets.session, &RunSession::stateChanged, this,
            &RunCommands::showLogs); // the folder is created with the first log
    QAction& open = m_actions.at("sim.openLogs");
    connect(&m_targets.status, &StatusLine::logsRequested, &open, &QAction::trigger);
    connect(&open, &QAction::triggered, this, &RunCommands::openLogs);
    showLogs();
}

void RunCommands::showLogs() {
    const QString& folder = m_targets.session.logs().folder();
    const bool exists = !folder.isEmpty() && QFileInfo::exists(folder);
    m_actions.at("sim.openLogs").setEnabled(exists);
    m_targets.status.setLogs(exists ? folder : QString());
}

void RunCommands::openLogs() {
    const QString& folder = m_targets.session.logs().folder();
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
        m_targets.status.refuse(tr("No file manager is available. The logs are in %1").arg(folder));
}

void RunCommands::connectRemote(QWidget& window) {
    QAction& action = m_actions.at("sim.remote");
    connect(&action, &QAction::triggered, this, [this, &window] {
        const std::string& python = m_targets.session.source().application().locations().python;
        if (!m_remoteDialog)
            m_remoteDialog = new RemoteDialog(m_targets.session.remote(), QString::fromStdString(python), &window);
        m_remoteDialog->show();
        m_remoteDialog->raise();
        m_remoteDialog->activateWindow();
    });
    connect(&m_targets.status, &StatusLine::remoteRequested, &action, &QAction::trigger);
    connect(&m_targets.session.remote(), &RemoteAccess::switched, this, &RunCommands::showRemote);
    connect(&m_targets.session.remote(), &RemoteAccess::clientsChanged, this, &RunCommands::showRemote);
}

void RunCommands::showRemote() {
    const RemoteAccess& remote = m_targets.session.remote();
    const std::size_t clients = remote.clientCount();
    m_targets.status.setRemote(!remote.isOn() ? QString()
                               : clients == 0 ? tr("remote: port %1").arg(remote.port())
                               : clients == 1 ? tr("remote: 1 program")
                                              : tr("remote: %1 programs").arg(clients));
}

void RunCommands::connectDriving(QWidget& window) {
    new KeyboardDrive(m_targets.session, m_targets.selection, m_actions, window); // child of the window
    connect(&m_actions.at("sim.drive"), &QAction::triggered, this, [this](bool drives) {
        if (!drives) return;
        m_targets.viewport.views().current().setFocus(); // in a text editor the arrows move the caret
        m_targets.status.refuse(tr("The arrow keys steer the selected robot while it runs, with Shift twice as fast."));
    });
    connect(&m_actions.at("sim.run"), &QAction::triggered, this,
            [this] { // the arrow keys should drive the robot, not edit the last row
                if (m_actions.at("sim.drive").isChecked()) m_targets.viewport.views().current().setFocus();
            });
}

} // namespace trundle
