// Shadows that lie on their floor already.
uniform mat4 osg_ViewMatrixInverse;
uniform float hazeDistance;
out float inHaze, fade;
out vec3 onFloor;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    fade = 1.0;
    onFloor = (osg_ViewMatrixInverse * eye).xyz;
    inHaze = length(eye.xyz) * (1.2011224 / hazeDistance);
    gl_Position = gl_ProjectionMatrix * eye;
}
