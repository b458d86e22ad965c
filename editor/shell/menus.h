#pragma once
#include <map>

#include <QMenu>
#include <QMenuBar>
#include <QString>

#include "editor/widgets/actions.h"

namespace trundle {

/// Builds a window's menus from the table of actions. Returns them by path ("File", "File/New"), so that callers can add actions
/// that are not in the table.
[[nodiscard]] std::map<QString, QMenu*> buildMenus(QMenuBar& bar, const Actions& actions);

} // namespace trundle
