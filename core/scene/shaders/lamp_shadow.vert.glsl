// The same for a lamp. The projected position is kept before the division, so that parts higher than the lamp can be clipped
// first; parts within 10 cm of the lamp belong to it and cast no shadow.
uniform mat4 osg_ViewMatrixInverse;
uniform mat4 osg_ViewMatrix;
uniform vec4 shadowPlane;
uniform vec3 shadowLamp;
uniform float lampHeight;
out vec4 onFloor;
void main() {
    vec3 world = (osg_ViewMatrixInverse * (gl_ModelViewMatrix * gl_Vertex)).xyz;
    float height = dot(shadowPlane.xyz, world) - shadowPlane.w, below = lampHeight - height;
    gl_ClipDistance[0] = height + 0.003;
    gl_ClipDistance[1] = below - 0.03 * lampHeight;
    gl_ClipDistance[2] = distance(world, shadowLamp) - 0.1;
    onFloor = vec4(shadowLamp * below + (world - shadowLamp) * lampHeight, below);
    gl_Position = gl_ProjectionMatrix * (osg_ViewMatrix * onFloor);
}
