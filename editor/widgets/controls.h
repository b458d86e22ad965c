#pragma once
// Controls used by several panels.

#include <QComboBox>
#include <QTableView>

class QToolButton;

namespace trundle {

enum class LineFont { Interface, Monospace };

/// A table of short lines without a grid, as dense as its font allows; selects whole rows, several at a time.
[[nodiscard]] QTableView* makeLineTable(const char* name, QAbstractItemModel* model, LineFont font, QWidget* parent = nullptr);

/// A combo box whose width does not depend on its entries. `tip` is also its accessible name.
[[nodiscard]] QComboBox* makeNarrowChoice(const char* name, const QString& tip, int characters, QWidget* parent);

/// Shows the icon, `size` pixels large, and the text beside it. Qt alone leaves only 2 pixels between them.
void showTextBesideIcon(QToolButton& button, int size = 16);

/// Resizes a dialog to a size made for the default font, larger with a larger font, and never beyond its screen.
void resizeToFont(QWidget& dialog, const QSize& atDefault);

} // namespace trundle
