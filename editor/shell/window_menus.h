#pragma once
#include <map>

#include <QMainWindow>
#include <QMenu>
#include <QObject>

#include "editor/widgets/actions.h"

namespace trundle {

class ControllersPanel;
class FileCommands;
class InsertMenu;
class Layouts;

/// The menus of the window, and the palette with all their commands.
class WindowMenus final : public QObject {
    Q_OBJECT
public:
    struct Parts {
        FileCommands& files;
        ControllersPanel& controllers;
        Layouts& layouts;
        InsertMenu& insert;
    };
    /// All arguments must outlive this object.
    WindowMenus(QMainWindow& window, Actions& actions, const Parts& parts);

private:
    void openPalette();
    [[nodiscard]] QList<QAction*> insertActions() const;

    QMainWindow& m_window;
    Actions& m_actions;
    Layouts& m_layouts;
    std::map<QString, QMenu*> m_menus;
};

} // namespace trundle
