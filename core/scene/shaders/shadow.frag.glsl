#include "light.glsl"
uniform float shadowDepth;
in float inHaze, fade;
out vec4 fragment;
#ifdef LAMPS
// Their light stays: the share that is the sun's is less near them. One layer of several takes a root of it.
uniform vec3 floorLight, floorNormal;
uniform float sunShare, sunPower; // without lamps; no power: it is not the sun that is hidden
in vec3 onFloor;
float depthHere() {
    float open = dot(floorLight, vec3(1.0)), lamps = dot(lampsOn(onFloor, floorNormal), vec3(1.0));
    float left = max(1.0 - sunShare * open / max(open + lamps, 1.0e-6), 1.0e-6);
    return sunPower > 0.0 ? 1.0 - pow(left, sunPower) : shadowDepth;
}
#else
float depthHere() { return shadowDepth; }
#endif
void main() { fragment = vec4(0.02, 0.03, 0.06, depthHere() * fade * exp2(-inHaze * inHaze)); }
