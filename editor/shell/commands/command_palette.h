#pragma once
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>

#include "editor/widgets/actions.h"

namespace trundle {

/// A list of all commands, filtered by typed letters. Enter runs the current one.
class CommandPalette final : public QDialog {
    Q_OBJECT
public:
    struct Command {
        QString name, menu;
        QPointer<QAction> action; ///< actions of a menu may be deleted and recreated each time it opens
    };
    /// `more`: commands that are not in the table of actions, such as those of the Insert menu.
    CommandPalette(const Actions& actions, std::vector<Command> more, QWidget* parent);

    /// How well `letters` match a command's name: 0 no match; words that begin with them score highest.
    [[nodiscard]] static int match(const QString& name, const QString& letters);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// As match(). "Undo Add Imu" is not what "imu" looks for: undo and redo are last, unless their own names are typed.
    [[nodiscard]] static int scoreOf(const Command& command, const QString& letters);
    void fill(const QString& letters);
    void trigger();

    std::vector<Command> m_commands;
    QLineEdit* m_search = new QLineEdit(this);
    QListWidget* m_list = new QListWidget(this);
    QLabel* m_none = new QLabel(m_list);
};

} // namespace trundle
