// A body with a texture instead of a colour.
#define PICTURED
#include "body.frag.glsl"
