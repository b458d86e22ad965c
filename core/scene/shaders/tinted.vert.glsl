// Overlay shape with interpolated vertex colours; most transparent where the line of sight grazes it.
#include "surface.glsl"
out vec4 colour;
void main() {
    vec4 eye = placeSurface();
    colour = gl_Color;
    gl_Position = gl_ProjectionMatrix * eye;
}
