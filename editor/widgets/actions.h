#pragma once
// The table of all actions of the window, used by menus, toolbars, the command palette and the shortcut editor.

#include <map>
#include <span>
#include <string>

#include <QAction>
#include <QObject>

namespace trundle {

struct ActionRow {
    const char* id;       ///< "edit.undo"
    const char* menu;     ///< "Edit", "Edit/Insert"; "" only in the palette. '|' starts a new group: "|Edit"
    const char* text;     ///< "&Undo"
    const char* icon;     ///< name of a file in resources/icons without extension, or ""
    const char* shortcut; ///< "Ctrl+Z", portable text; "" none
    const char* help;     ///< one sentence
    bool checkable = false;
};

/// Owns a QAction for each table row. Panels connect to them by id; an unknown id is a bug.
class Actions final : public QObject {
    Q_OBJECT
public:
    explicit Actions(std::span<const ActionRow> table, QObject* parent = nullptr);

    [[nodiscard]] QAction& at(const char* id) const;
    [[nodiscard]] std::span<const ActionRow> table() const { return m_table; }
    /// Shortcuts changed by the user are saved in QSettings under "shortcuts/<id>".
    void setShortcut(const char* id, const QKeySequence& keys);
    void resetShortcut(const char* id);

private:
    std::span<const ActionRow> m_table;
    std::map<std::string, QAction*, std::less<>> m_actions;
};

} // namespace trundle
