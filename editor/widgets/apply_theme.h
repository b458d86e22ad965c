#pragma once
#include "editor/widgets/theme.h"

class QApplication;

namespace trundle {

/// Sets palette, style sheet and fonts of the application, and plain text display (plain_text.h). The result does not depend on
/// platform or desktop.
void applyTheme(QApplication& application, ThemeKind kind, const FontSizes& sizes = {});

} // namespace trundle
