#pragma once
// The text of a mirrored Part. Private to core/project.

#include <string>

#include "base/result.h"

namespace trundle {

/// The text of the mirror image of a Part along 'x', 'y' or 'z' of the config that it is in: another `Mirror`, and the signs in its
/// Pos and HPR. Fails where they are not numbers and expressions one by one, or where it is mirrored along another axis already.
[[nodiscard]] Result<std::string> mirroredPart(const std::string& text, const std::string& name, char axis);
/// "rightDrive" for "leftDrive", the same for front and rear, upper and lower; other names are returned as they are.
[[nodiscard]] std::string mirroredName(const std::string& name);

} // namespace trundle
