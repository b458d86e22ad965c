#pragma once
// HPR in texts: each rotation has several triples of angles, and an edit starts from the one that is written.

#include <trundle/geometry.h>

#include "project/objects/object_location.h"

namespace trundle {

/// HPR (rad) of a block as its text has it, without whole turns; the one of hprFromRotation() if the text has none that means this
/// rotation.
[[nodiscard]] Vec3 writtenHpr(const LoadedProject& loaded, const ObjectLocation& place, const Quat& rotation);
/// HPR (rad) of a rotation, with as many of the written angles as it can have: beyond a pitch of 90 degrees if the written one is,
/// and straight up or down, where heading and roll turn about one axis, with the written roll.
[[nodiscard]] Vec3 hprLike(const Vec3& written, const Quat& rotation);

} // namespace trundle
