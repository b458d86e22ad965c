#pragma once
// Every action of the window in one table: menus, toolbars, the command palette and the shortcut editor read it.

#include <map>
#include <span>
#include <string>

#include <QAction>
#include <QObject>

namespace trundle {

struct ActionRow {
    const char* id;       ///< "edit.undo"
    const char* menu;     ///< "Edit", "Edit/Insert"; "" only in the palette. A new group starts with '|': "|Edit"
    const char* text;     ///< "&Undo"
    const char* icon;     ///< name of a file in resources/icons without ending, or ""
    const char* shortcut; ///< "Ctrl+Z", portable text; "" none
    const char* help;     ///< one sentence
    bool checkable = false;
};

/// Owns a QAction for each row. Parts connect to them by id; an id that is not in the table is a bug.
class Actions final : public QObject {
    Q_OBJECT
public:
    explicit Actions(std::span<const ActionRow> table, QObject* parent = nullptr);

    [[nodiscard]] QAction& at(const char* id) const;
    [[nodiscard]] std::span<const ActionRow> table() const { return m_table; }
    /// Shortcuts the user changed, kept in QSettings under "shortcuts/<id>".
    void setShortcut(const char* id, const QKeySequence& keys);
    void resetShortcut(const char* id);

private:
    std::span<const ActionRow> m_table;
    std::map<std::string, QAction*, std::less<>> m_actions;
};

} // namespace trundle
