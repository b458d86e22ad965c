#pragma once

class QWidget;

namespace trundle {

/// The mouse wheel scrolls the panel instead of changing a widget that has no focus.
void ignoreWheel(QWidget& widget);

} // namespace trundle
