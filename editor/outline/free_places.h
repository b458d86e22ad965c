#pragma once
// Where new robots and statics are put if they were inserted without a position under the mouse.

#include <vector>

#include "editor/document/document.h"

namespace trundle {

/// Values of Pos that move what `now` has and `before` has not to the nearest free place on the floor, as a whole. Nothing if it is
/// free where it is written, or has no shapes. Floors under a new static do not count as in its way.
[[nodiscard]] std::vector<ValueEdit> freePlaces(const LoadedProject& before, const LoadedProject& now);

} // namespace trundle
