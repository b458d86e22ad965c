#pragma once
#include <QString>
#include <QStringList>

#include "editor/document/document.h"

namespace trundle {

/// The files with unsaved changes as shown to people, the opened one first. A new text that no file holds yet is one of them.
[[nodiscard]] QStringList unsavedFiles(const Document& document);
/// "a.sim, b.sim and 3 more": the first ones, and how many more there are.
[[nodiscard]] QString listed(const QStringList& names, qsizetype most);
/// "main.sim[*] – Trundle", "main.sim, rover.sim[*] – Trundle": the opened file, then the others that are not saved. A file with unsaved
/// changes has a star; `[*]` is the one that QWidget::setWindowModified() shows.
[[nodiscard]] QString windowTitle(const Document& document);

} // namespace trundle
