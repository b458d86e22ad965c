#include "light.glsl"
#include "shadow_maps.glsl"
#include "floor_light.glsl"
#include "grid_lines.glsl"
uniform vec3 floorColour;
uniform float floorLines;
in vec2 onFloor;
in vec3 inHaze, positionW;
flat in vec3 floorShown;
out vec4 fragment;
void main() {
    vec2 w = max(fwidth(onFloor), vec2(1e-6));
    vec2 pixels = 1.0 / w;
    float ink = gridInk(onFloor, w, pixels);
    // Every second metre a shade darker.
    vec2 tile = abs(fract(onFloor * 0.5) - 0.5);
    vec2 edge = clamp((tile - 0.25) * (2.0 * pixels), -0.5, 0.5);
    float checker = edge.x * edge.y * clamp(1.0 - 4.0 * max(w.x, w.y), 0.0, 1.0);
    float left = (1.0 - ink * floorLines) * (1.0 + 0.120 * checker * floorLines); // of the floor's own colour
#ifdef LIGHT_VARIES
    vec3 shown = floorColour * sqrt(left * floorLightAt(positionW));
#elif defined(LAMPS) || defined(LEDS)
    vec3 shown = floorColour * sqrt(left * (floorLight + lampsOn(positionW, floorNormal) + ledsOn(positionW, floorNormal)));
#else
    vec3 shown = floorShown * sqrt(left);
#endif
    fragment = vec4(mix(horizonColour, shown, exp2(-dot(inHaze, inHaze))), 1.0);
}
