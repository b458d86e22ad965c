#pragma once
#include <map>

#include <QMenu>
#include <QMenuBar>
#include <QString>

#include "editor/widgets/actions.h"

namespace trundle {

/// Menus of a window as the table says; by path ("File", "File/New"), so that others may add what is not in the table.
[[nodiscard]] std::map<QString, QMenu*> buildMenus(QMenuBar& bar, const Actions& actions);

} // namespace trundle
