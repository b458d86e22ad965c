#pragma once
#include <vector>

#include <QWidget>

#include "editor/running/module_list.h"
#include "project/edits/controllers.h"

class QLabel;
class QMenu;
class QToolButton;
class QTreeWidget;

namespace trundle {

class Actions;
class ControllerCommands;
class ControllerDetails;
class Document;
class RunSession;
class Selection;

/// The modules of the experiment and the controller of each robot. Implements the actions controllers.load and those behind it.
class ControllersPanel final : public QWidget {
    Q_OBJECT
public:
    ControllersPanel(Document& document, Selection& selection, RunSession& session, Actions& actions, QWidget* parent = nullptr);

    [[nodiscard]] ControllerCommands& commands() { return *m_commands; }
    /// Recently loaded modules; each action loads one.
    [[nodiscard]] QMenu* recentMenu() const { return m_recent; }
    /// Asks for a controller and assigns it to the robots.
    void assignTo(const std::vector<std::string>& robots);

Q_SIGNALS:
    void refused(const QString& reason);
    void jumpTo(const std::string& file, const trundle::SourceRange& range); ///< the line of a module in the text
    void attentionRequested();                                               ///< a module's folder is not trusted

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeModules();
    QWidget* makeRobots();
    void connectActions();
    void refresh();
    void refreshModules();
    void refreshRobots();
    void showStates();
    void showStopped();
    void showButtons();
    void showNumbers();
    void isolate(bool alone);
    void copyDebuggerCommand();
    [[nodiscard]] const ControlledRobot* chosenController() const;
    void showRecent();
    void loadByDialog();
    [[nodiscard]] const ModuleInfo* currentModule() const;
    [[nodiscard]] std::vector<std::string> chosenRobots() const;
    [[nodiscard]] std::vector<std::string> controlledMembers() const;

    Document& m_document;
    Selection& m_selection;
    RunSession& m_session;
    Actions& m_actions;
    ControllerCommands* m_commands;
    std::vector<ModuleInfo> m_infos;
    std::vector<ControlledRobot> m_listed;
    QLabel* m_notice = nullptr;
    QTreeWidget* m_modules = nullptr;
    QTreeWidget* m_robots = nullptr;
    ControllerDetails* m_details = nullptr;
    QToolButton* m_unload = nullptr;
    QToolButton* m_trust = nullptr;
    QMenu* m_recent = nullptr;
    std::size_t m_stopped = 0; // controllers in the run, as shown
    bool m_choosing = false; // this panel is changing the selection
    bool m_stale = false;    // the rows must be rebuilt when the panel is shown
};

} // namespace trundle
