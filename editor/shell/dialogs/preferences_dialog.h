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

/// Theme, fonts, text and navigation settings, shortcuts of every action, and the folders whose modules may run. Changes apply
/// and are saved at once.
class PreferencesDialog final : public QDialog {
    Q_OBJECT
public:
    PreferencesDialog(Actions& actions, QWidget* parent);

    /// Id of the action, other than `id`, that has this shortcut; "" if it is free.
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
    /// Whether the shortcut is free, or the user agrees to remove it from the action that has it.
    [[nodiscard]] bool areFree(const char* id, const QKeySequence& keys);
    void setKeys(const char* id, const QKeySequence& keys);

    Actions& m_actions;
    Preferences m_preferences = loadPreferences();
    QComboBox *m_theme = nullptr, *m_wrap = nullptr, *m_navigation = nullptr;
    QSpinBox *m_interfaceFont = nullptr, *m_textFont = nullptr;
    QLabel* m_buttons = nullptr; ///< mouse buttons of the selected navigation style
    QLineEdit* m_filter = new QLineEdit;
    QTreeWidget* m_shortcuts = new QTreeWidget;
    QListWidget* m_folders = new QListWidget;
};

} // namespace trundle
