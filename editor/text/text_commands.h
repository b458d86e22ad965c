#pragma once
// What the text editor does for actions of the table, while the keyboard is in a text.

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

    /// The keys of the action mean this in a text, whatever the action does elsewhere ("edit.duplicate" doubles a line).
    void inText(const char* id, std::function<void()> run);
    /// The action is the text editor's own: it works from the menu and the command palette as well.
    void own(const char* id, std::function<void()> run);
    /// Keys pressed in this widget are looked up from now on.
    void watch(QWidget& edit);
    /// Does what an action means in a text; false where it means nothing here.
    bool carryOut(const std::string& id) const;

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
