// The grid lines alone.
#include "grid_lines.glsl"
in vec2 onFloor;
in vec3 inHaze;
out vec4 fragment;
void main() {
    vec2 w = max(fwidth(onFloor), vec2(1e-6));
    fragment = vec4(0.13, 0.15, 0.18, gridInk(onFloor, w, 1.0 / w) * exp2(-dot(inHaze, inHaze)));
}
