#pragma once
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>

#include "editor/widgets/actions.h"

namespace trundle {

/// A list of every command, narrowed by a few letters. Enter does it.
class CommandPalette final : public QDialog {
    Q_OBJECT
public:
    struct Command {
        QString name, menu;
        QPointer<QAction> action; ///< those of a menu are made anew each time that it opens
    };
    /// `more`: commands that are not in the table, as those of the Insert menu.
    CommandPalette(const Actions& actions, std::vector<Command> more, QWidget* parent);

    /// How well `letters` fit a command's name: 0 not at all; words that begin with them count most.
    [[nodiscard]] static int match(const QString& name, const QString& letters);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill(const QString& letters);
    void trigger();

    std::vector<Command> m_commands;
    QLineEdit* m_search = new QLineEdit(this);
    QListWidget* m_list = new QListWidget(this);
    QLabel* m_none = new QLabel(m_list);
};

} // namespace trundle
