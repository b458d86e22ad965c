#pragma once
// The text of a mirrored Part, and what speaks against it. Private to core/project.

#include <string>

#include "base/result.h"
#include "project/edits/plan_targets.h"

namespace trundle {

/// The text of the mirror image of a Part along 'x', 'y' or 'z' of the config that it is in: another `Mirror`, and the signs in its
/// Pos and HPR. Fails where they are not numbers and expressions one by one, or where it is mirrored along another axis already.
[[nodiscard]] Result<std::string> mirroredPart(const std::string& text, const std::string& name, char axis);
/// Fails if each body of the blocks would have its mirror image in the place of a body that there is: its own, or another one of the
/// same shapes. The blocks are mirrored together, at the plane of the first that counts from no other one. Shapes are the same if there
/// are as many, each of the kind and in the place of another one. Of a PartConfig those of its first use in a robot count; without one
/// the Parts beside a Part, by their Config, pose and Mirror.
[[nodiscard]] Status checkMirrorImage(const LoadedProject& loaded, const std::vector<Chosen>& blocks, char axis);
/// "rightDrive" for "leftDrive", the same for front and rear, upper and lower; other names are returned as they are.
[[nodiscard]] std::string mirroredName(const std::string& name);

} // namespace trundle
