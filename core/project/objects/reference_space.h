#pragma once
#include "model/outline.h"

namespace trundle {

/// The name space in which a reference to a block of this kind is looked up; nullptr: the config of its user. A joint at the top level,
/// between robots, is never referred to.
[[nodiscard]] inline const NameSpace* referenceSpace(const Outline& outline, const Kind& kind) {
    return kind.role == Role::Joint ? nullptr : outline.spaceOf(kind);
}

} // namespace trundle
