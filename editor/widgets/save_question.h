#pragma once
#include <QFileDialog>

namespace trundle {

/// Asks where to save. A name without an ending gets `suffix`, before it is looked whether such a file is there already. Empty where
/// nobody wants to.
[[nodiscard]] QString askWhereToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter,
                                     const QString& suffix, QFileDialog::Options options = {});

} // namespace trundle
