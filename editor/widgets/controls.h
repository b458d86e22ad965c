#pragma once
// Controls that several panels have alike.

#include <QComboBox>
#include <QTableView>

namespace trundle {

enum class LineFont { Interface, Monospace };

/// A table of short lines without a grid, as dense as its font allows; rows are selected whole, several at a time.
[[nodiscard]] QTableView* makeLineTable(const char* name, QAbstractItemModel* model, LineFont font, QWidget* parent = nullptr);

/// A choice that stays narrow whatever is in it. `tip` is its accessible name as well.
[[nodiscard]] QComboBox* makeNarrowChoice(const char* name, const QString& tip, int characters, QWidget* parent);

} // namespace trundle
