#pragma once
#include <QFileDialog>

namespace trundle {

/// Asks for a file to save to. A name without an extension gets `suffix` before the check for an existing file. Empty if the
/// user cancels.
[[nodiscard]] QString askWhereToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter,
                                     const QString& suffix, QFileDialog::Options options = {});

} // namespace trundle
