// Depth along the optical axis and object number.
#include "layers.glsl"
uniform float firstObject;
out float depth;
flat out float object;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    depth = -eye.z;
    object = firstObject + gl_MultiTexCoord2.x;
    gl_Position = inLayer(gl_ProjectionMatrix * eye);
}
