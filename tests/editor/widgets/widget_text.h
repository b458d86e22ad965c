#pragma once
// A text that describes what a window shows and offers: its widgets with their texts, tool tips, states and options, the items of
// its lists, tables and trees, and its menus. Compared with a text in tests/data/window.

#include <QString>

class QWidget;

namespace trundle {

/// Numbers of a run, which depend on the physics, are written as #.
enum class Numbers { Shown, Hidden };

/// The visible widgets below `root`, indented by depth.
[[nodiscard]] QString describedWidget(const QWidget& root);
/// Compares with tests/data/window/`name`.txt after `masked` (paths of this machine) was replaced by FOLDER; empty if equal,
/// otherwise the first lines that differ. With TRUNDLE_WRITE_WINDOW_TEXTS in the environment the file is written instead.
[[nodiscard]] QString differenceFromKept(const QString& name, QString description, const QString& masked,
                                         Numbers numbers = Numbers::Shown);

} // namespace trundle
