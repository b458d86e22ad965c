#pragma once
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QTreeWidget>

#include "editor/widgets/actions.h"
#include "editor/widgets/preferences.h"

class QComboBox;
class QLabel;
class QSpinBox;

namespace trundle {

/// Theme, fonts and the like, shortcuts of every action, and the folders whose modules may run. All is kept and works at once.
class PreferencesDialog final : public QDialog {
    Q_OBJECT
public:
    PreferencesDialog(Actions& actions, QWidget* parent);

    /// The action, other than `id`, that has these keys; "" where they are free.
    [[nodiscard]] static QString ownerOf(const Actions& actions, const QKeySequence& keys, const char* id);

Q_SIGNALS:
    void changed(const Preferences& before, const Preferences& now);

private:
    QWidget* makeGeneral();
    void take();
    QWidget* makeShortcuts();
    QWidget* makeTrust();
    void fillShortcuts();
    void narrow();
    /// Takes the keys from who has them, if that is wanted.
    [[nodiscard]] bool areFree(const char* id, const QKeySequence& keys);
    void setKeys(const char* id, const QKeySequence& keys);

    Actions& m_actions;
    Preferences m_preferences = loadPreferences();
    QComboBox *m_theme = nullptr, *m_wrap = nullptr, *m_navigation = nullptr;
    QSpinBox *m_interfaceFont = nullptr, *m_textFont = nullptr;
    QLabel* m_buttons = nullptr; ///< of the mouse, in the chosen style
    QLineEdit* m_filter = new QLineEdit;
    QTreeWidget* m_shortcuts = new QTreeWidget;
    QListWidget* m_folders = new QListWidget;
};

} // namespace trundle
