// Normal of the visible face towards the eye, and its distance.
#include "layers.glsl"
out vec3 inView;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    inView = eye.xyz;
    gl_Position = inLayer(gl_ProjectionMatrix * eye);
}
