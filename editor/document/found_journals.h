#pragma once
#include <QString>

namespace trundle {

class Document;

/// Why unsaved edits found inside the project's own folder are not offered for recovery, and what to do; empty if there are
/// none.
[[nodiscard]] QString journalsNotRead(const Document& document);

} // namespace trundle
