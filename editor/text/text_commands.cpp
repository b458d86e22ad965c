#include "editor/text/text_commands.h"

#include <QKeyEvent>
#include <QWidget>

#include "editor/widgets/actions.h"

namespace trundle {

void TextCommands::inText(const char* id, std::function<void()> run) { m_commands.push_back({id, std::move(run)}); }

void TextCommands::own(const char* id, std::function<void()> run) {
    connect(&m_actions.at(id), &QAction::triggered, this, run);
    inText(id, std::move(run));
}

void TextCommands::watch(QWidget& edit) { edit.installEventFilter(this); }

bool TextCommands::apply(const std::string& id) const {
    for (const Command& command : m_commands) {
        if (command.id != id) continue;
        command.run();
        return true;
    }
    return false;
}

const TextCommands::Command* TextCommands::commandOf(const QKeyEvent& event) const {
    const int key = event.key() == Qt::Key_Enter ? Qt::Key_Return : event.key();
    const QKeySequence pressed(static_cast<int>(event.modifiers() & ~Qt::KeypadModifier) | key);
    for (const Command& command : m_commands)
        if (m_actions.at(command.id.c_str()).shortcuts().contains(pressed)) return &command;
    return nullptr;
}

bool TextCommands::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QObject::eventFilter(watched, event);
    const Command* command = commandOf(*static_cast<QKeyEvent*>(event));
    if (!command) return QObject::eventFilter(watched, event);
    event->accept(); // takes precedence over the window's shortcut with the same keys
    if (event->type() == QEvent::KeyPress) std::function(command->run)();
    return true;
}

} // namespace trundle
