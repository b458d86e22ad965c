// Flattens bodies onto a plane along the light. Parts below the plane are clipped, since they cast no shadow on it. The shadow
// fades with the caster's height, up to shadowTop.
uniform mat4 osg_ViewMatrixInverse;
uniform mat4 osg_ViewMatrix;
uniform vec4 shadowPlane;
uniform float shadowHeightScale;
uniform float shadowTop;
uniform float hazeDistance;
out float inHaze, fade;
out vec3 onFloor;
void main() {
    vec3 world = (osg_ViewMatrixInverse * (gl_ModelViewMatrix * gl_Vertex)).xyz;
    float height = dot(shadowPlane.xyz, world) - shadowPlane.w;
    gl_ClipDistance[0] = height / shadowHeightScale + 0.003;
    gl_ClipDistance[1] = shadowTop - height / shadowHeightScale;
    fade = 1.0 - height / (shadowHeightScale * shadowTop);
    onFloor = world - height * shadowPlane.xyz;
    vec4 eye = osg_ViewMatrix * vec4(onFloor, 1.0);
    inHaze = length(eye.xyz) * (1.2011224 / hazeDistance);
    gl_Position = gl_ProjectionMatrix * eye;
}
