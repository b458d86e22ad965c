#pragma once
#include "base/triangle_mesh.h"

namespace trundle {

/// Reverses triangles so that they are counter-clockwise seen from outside. A mesh consists of shells, whose triangles are joined
/// by edges. In a closed shell all triangles get the same side outside, and one that is inside out is reversed. Shells inside it
/// are reversed with it; those inside a sound one, such as cavities, stay. Shells that are open, flat or, like a Klein bottle,
/// without an inside stay as they are, and so do all shells of a mesh of very many of which only some are inside out. Equal points
/// must have been merged. A sound mesh stays the same to the bit.
void orientOutwards(TriangleMesh& mesh);

} // namespace trundle
