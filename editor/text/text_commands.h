#pragma once
// The text editor's commands for entries of the table of actions, active while a text has the focus.

#include <functional>
#include <string>
#include <vector>

#include <QObject>

class QKeyEvent;
class QWidget;

namespace trundle {

class Actions;

class TextCommands final : public QObject {
    Q_OBJECT
public:
    explicit TextCommands(Actions& actions, QObject* parent = nullptr) : QObject(parent), m_actions(actions) {}

    /// While a text has the focus, the action's shortcut runs this instead ("edit.duplicate" duplicates a line).
    void inText(const char* id, std::function<void()> run);
    /// The action belongs to the text editor: it also works from the menu and the command palette.
    void own(const char* id, std::function<void()> run);
    /// Handles shortcuts pressed in this widget.
    void watch(QWidget& edit);
    /// Runs the text command of an action; false if it has none.
    bool apply(const std::string& id) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Command {
        std::string id;
        std::function<void()> run;
    };
    [[nodiscard]] const Command* commandOf(const QKeyEvent& event) const;

    Actions& m_actions;
    std::vector<Command> m_commands;
};

} // namespace trundle
