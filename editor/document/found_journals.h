#pragma once
#include <QString>

namespace trundle {

class Document;

/// Why unsaved edits that were found inside the project's own folder are not offered, and what to do; empty where none were found.
[[nodiscard]] QString journalsNotRead(const Document& document);

} // namespace trundle
