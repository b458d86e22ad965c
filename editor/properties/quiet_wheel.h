#pragma once

class QWidget;

namespace trundle {

/// A wheel turned over a list that has no focus scrolls the panel instead of changing the value.
void quietWheel(QWidget& widget);

} // namespace trundle
