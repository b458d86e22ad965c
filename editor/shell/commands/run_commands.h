#pragma once
#include <QObject>
#include <QPointer>
#include <QWidget>

#include "editor/shell/dialogs/remote_dialog.h"
#include "editor/widgets/actions.h"

namespace trundle {

class Layouts;
class ProblemsPanel;
class RunSession;
class Selection;
class StatusLine;
class ViewportPanel;

/// What the window does when a run starts, ends or reports something: logs, problems, the keyboard.
class RunCommands final : public QObject {
    Q_OBJECT
public:
    struct Targets {
        RunSession& session;
        Selection& selection;
        ViewportPanel& viewport;
        ProblemsPanel& problems;
        Layouts& layouts;
        StatusLine& status;
    };
    /// All targets must outlive this object.
    RunCommands(QWidget& window, Actions& actions, const Targets& targets);

private:
    void connectLogs();
    void connectDriving(QWidget& window);
    void showMessages();
    void showEnd();
    void showLogs();
    void openLogs();
    void connectRemote(QWidget& window);
    void showRemote();

    Actions& m_actions;
    Targets m_targets;
    QPointer<RemoteDialog> m_remoteDialog; ///< while it is open
};

} // namespace trundle
