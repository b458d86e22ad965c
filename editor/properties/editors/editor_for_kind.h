#pragma once
#include "editor/properties/row.h"

namespace trundle {

class RowEditor;

/// Creates the editor for a kind of value.
[[nodiscard]] RowEditor* makeEditor(EditorKind kind, QWidget* parent);

} // namespace trundle
