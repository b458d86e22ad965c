#include "editor/shell/menus.h"

namespace trundle {

static QMenu* menuAt(QMenuBar& bar, std::map<QString, QMenu*>& menus, const QString& path) {
    if (const auto it = menus.find(path); it != menus.end()) return it->second;
    const qsizetype slash = path.lastIndexOf(QLatin1Char('/'));
    const QString title = QMenu::tr(qPrintable(path.mid(slash + 1)));
    QMenu* menu = slash < 0 ? bar.addMenu(QLatin1Char('&') + title) : menuAt(bar, menus, path.left(slash))->addMenu(title);
    menu->setObjectName(QStringLiteral("menu.") + path);
    menu->setToolTipsVisible(true);
    menus[path] = menu;
    return menu;
}

std::map<QString, QMenu*> buildMenus(QMenuBar& bar, const Actions& actions) {
    std::map<QString, QMenu*> menus;
    for (const char* first : {"File", "Edit", "View", "Insert", "Tools", "Simulation", "Controllers", "Help"})
        (void)menuAt(bar, menus, QLatin1String(first));
    for (const ActionRow& row : actions.table()) {
        QString path = QLatin1String(row.menu);
        if (path.isEmpty()) continue;
        const bool newGroup = path.startsWith(QLatin1Char('|'));
        if (newGroup) path.remove(0, 1);
        if (newGroup) {
            const qsizetype slash = path.lastIndexOf(QLatin1Char('/'));
            const bool opensSubmenu = slash > 0 && !menus.contains(path);
            menuAt(bar, menus, opensSubmenu ? path.left(slash) : path)->addSeparator();
        }
        menuAt(bar, menus, path)->addAction(&actions.at(row.id));
    }
    return menus;
}

} // namespace trundle
