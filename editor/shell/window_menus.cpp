#include "editor/shell/window_menus.h"

#include <functional>

#include <QMenuBar>

#include "editor/outline/insert_menu.h"
#include "editor/running/panels/controllers_panel.h"
#include "editor/shell/commands/command_palette.h"
#include "editor/shell/commands/file_commands.h"
#include "editor/shell/layouts.h"
#include "editor/shell/menus.h"

namespace trundle {

WindowMenus::WindowMenus(QMainWindow& window, Actions& actions, const Parts& parts)
    : QObject(&window), m_window(window), m_actions(actions), m_layouts(parts.layouts),
      m_menus(buildMenus(*window.menuBar(), actions)) {
    m_menus.at(QStringLiteral("File"))->insertMenu(&actions.at("file.openSample"), parts.files.makeRecentMenu());
    m_menus.at(QStringLiteral("Controllers"))->insertMenu(&actions.at("controllers.assign"), parts.controllers.recentMenu());
    m_menus.at(QStringLiteral("View"))->insertMenu(m_menus.at(QStringLiteral("View/Layout"))->menuAction(), m_layouts.menu());
    parts.insert.attach(*m_menus.at(QStringLiteral("Insert")));
    connect(&actions.at("edit.palette"), &QAction::triggered, this, &WindowMenus::openPalette);
}

QList<QAction*> WindowMenus::insertActions() const {
    QList<QAction*> leaves;
    QMenu* insert = m_menus.at(QStringLiteral("Insert"));
    Q_EMIT insert->aboutToShow();
    // Follows the menus rather than findChildren(), which would include actions just removed by aboutToShow().
    const std::function<void(const QMenu&)> collect = [&](const QMenu& menu) {
        for (QAction* action : menu.actions()) {
            if (action->menu()) collect(*action->menu());
            else if (action->objectName().startsWith(QStringLiteral("insert."))) leaves.append(action);
        }
    };
    collect(*insert);
    return leaves;
}

void WindowMenus::openPalette() {
    std::vector<CommandPalette::Command> more;
    for (QAction* action : insertActions())
        more.push_back({tr("Insert %1").arg(action->text().remove(QLatin1Char('&'))), tr("Insert"), action});
    for (QAction* action : m_layouts.raising()) more.push_back({action->text(), tr("View"), action});
    auto* palette = new CommandPalette(m_actions, std::move(more), &m_window);
    palette->setAttribute(Qt::WA_DeleteOnClose);
    palette->show();
}

} // namespace trundle
