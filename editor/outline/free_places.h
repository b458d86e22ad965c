#pragma once
// Where new robots and statics are put if they were inserted without a position under the mouse.

#include <optional>
#include <vector>

#include "editor/document/document.h"

namespace trundle {

/// Values of Pos that move what `now` has and `before` has not, as a whole, to a free place on the floor: the nearest one to `near`
/// (m, W), or without it to the position as written. Nothing if that is free already, or there are no shapes. Floors under a new
/// static do not count as in its way.
[[nodiscard]] std::vector<ValueEdit> freePlaces(const LoadedProject& before, const LoadedProject& now,
                                                const std::optional<Vec3>& near = {});

} // namespace trundle
