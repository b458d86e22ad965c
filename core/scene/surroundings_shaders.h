#pragma once
// GLSL programs of sky and planar shadows; conventions as in shaders.h.

namespace trundle::shaders {

inline constexpr const char* kSkyVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
out vec3 direction;
void main() {
    vec4 p = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    // A parallel projection has one direction only; its rays differ in where they start.
    direction = mat3(osg_ViewMatrixInverse) * mix(vec3(0.0, 0.0, -1.0), p.xyz / p.w, gl_ProjectionMatrix[2][3] != 0.0 ? 1.0 : 0.0);
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
}
)";

inline constexpr const char* kSkyFragment = R"(
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
)";

/// Flattens bodies onto a plane along the light. Parts below the plane are clipped, since they cast no shadow on it. The shadow
/// fades with the caster's height, up to shadowTop.
inline constexpr const char* kShadowVertex = R"(
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
)";

inline constexpr const char* kShadowFragment = R"(
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
)";

/// The same for a lamp. The projected position is kept before the division, so that parts higher than the lamp can be clipped
/// first; parts within 10 cm of the lamp belong to it and cast no shadow.
inline constexpr const char* kLampShadowVertex = R"(
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
)";

inline constexpr const char* kLampShadowFragment = R"(
uniform mat4 osg_ViewMatrixInverse;
uniform vec3 floorLight, floorNormal, shadowLamp, shadowLight;
uniform float hazeDistance;
in vec4 onFloor;
out vec4 fragment;
void main() {
    vec3 place = onFloor.xyz / onFloor.w, way = shadowLamp - place;
    float square = max(dot(way, way), 1.0e-4);
    vec3 taken = shadowLight * max(dot(floorNormal, way), 0.0) * inversesqrt(square) / square;
    vec3 all = floorLight + lampsOn(place, floorNormal);
    float share = dot(taken, vec3(1.0)) / max(dot(all, vec3(1.0)), 1.0e-6);
    float far = distance(osg_ViewMatrixInverse[3].xyz, place) / hazeDistance;
    fragment = vec4(0.02, 0.03, 0.06, (1.0 - sqrt(max(1.0 - share, 0.0))) * exp(-far * far));
}
)";

} // namespace trundle::shaders
