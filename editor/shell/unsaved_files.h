#pragma once
#include <QString>
#include <QStringList>

#include "editor/document/document.h"

namespace trundle {

/// Display names of the files with unsaved changes, the opened one first. Includes a new text that is not saved to a file yet.
[[nodiscard]] QStringList unsavedFiles(const Document& document);
/// "main.sim[*] – Trundle", "main.sim, rover.sim[*] – Trundle": the opened file, then the other unsaved ones. A file with
/// unsaved changes has a star; `[*]` is the placeholder of QWidget::setWindowModified(). Says if the project
/// is open read-only.
[[nodiscard]] QString windowTitle(Document& document);

} // namespace trundle
