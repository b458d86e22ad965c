#include "light.glsl"
uniform vec3 sunGlow, skyBelow;
in vec3 direction;
out vec4 fragment;
void main() {
    vec3 d = normalize(direction);
    vec3 colour = skyColour(d);
    float near = max(dot(d, sunWay), 0.0);
    near *= near * near;
    near *= near;
    near *= near;
    colour += sunGlow * (near * near); // to the power of 24
    // Where there is no floor the ground below fades to grey.
    colour = mix(colour, skyBelow, smoothstep(0.0, 0.5, -d.z));
    fragment = vec4(colour, 1.0);
}
