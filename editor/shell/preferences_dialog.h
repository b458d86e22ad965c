#pragma once
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QTreeWidget>

#include "editor/widgets/actions.h"

namespace trundle {

/// Shortcuts of every action, and the folders whose modules may run.
class PreferencesDialog final : public QDialog {
    Q_OBJECT
public:
    PreferencesDialog(Actions& actions, QWidget* parent);

    /// The action, other than `id`, that has these keys; "" where they are free.
    [[nodiscard]] static QString ownerOf(const Actions& actions, const QKeySequence& keys, const char* id);

private:
    QWidget* makeShortcuts();
    QWidget* makeTrust();
    void fillShortcuts();
    void narrow();
    /// Takes the keys from who has them, if that is wanted.
    [[nodiscard]] bool areFree(const char* id, const QKeySequence& keys);
    void setKeys(const char* id, const QKeySequence& keys);

    Actions& m_actions;
    QLineEdit* m_filter = new QLineEdit;
    QTreeWidget* m_shortcuts = new QTreeWidget;
    QListWidget* m_folders = new QListWidget;
};

} // namespace trundle
