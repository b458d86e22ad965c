// A texture instead of grid lines; `pictureScale` repetitions per metre.
#include "light.glsl"
#include "shadow_maps.glsl"
#include "floor_light.glsl"
uniform sampler2D picture;
uniform float pictureScale;
in vec2 onFloor;
in vec3 inHaze, positionW;
out vec4 fragment;
void main() {
    vec3 colour = texture(picture, vec2(onFloor.x, -onFloor.y) * pictureScale).rgb;
#ifdef LIGHT_VARIES
    vec3 shown = sqrt(colour * colour * floorLightAt(positionW));
#else
    vec3 shown = sqrt(colour * colour * (floorLight + lampsOn(positionW, floorNormal) + ledsOn(positionW, floorNormal)));
#endif
    fragment = vec4(mix(horizonColour, shown, exp2(-dot(inHaze, inHaze))), 1.0);
}
