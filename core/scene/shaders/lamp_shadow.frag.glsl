#include "light.glsl"
uniform mat4 osg_ViewMatrixInverse;
uniform vec3 floorLight, floorNormal, shadowLamp, shadowLight;
uniform float hazeDistance;
in vec4 onFloor;
out vec4 fragment;
void main() {
    vec3 place = onFloor.xyz / onFloor.w;
    vec3 taken = lampOn(shadowLight, shadowLamp - place, floorNormal);
    vec3 all = floorLight + lampsOn(place, floorNormal);
    float share = dot(taken, vec3(1.0)) / max(dot(all, vec3(1.0)), 1.0e-6);
    float far = distance(osg_ViewMatrixInverse[3].xyz, place) / hazeDistance;
    fragment = vec4(0.02, 0.03, 0.06, (1.0 - sqrt(max(1.0 - share, 0.0))) * exp(-far * far));
}
