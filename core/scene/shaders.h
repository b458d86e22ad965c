#pragma once
// GLSL 1.30 for a compatibility context. Colours enter and leave as shown on a screen; light is added up linearly, with a
// square for the screen's curve. No branch depends on a uniform: software renderers pay for every branch.

namespace trundle::shaders {

/// Follows the constants kSun, kSunLight, kSkyLight and kGroundLight, which look.cpp writes.
inline constexpr const char* kLight = R"(
const vec3 kHorizon = vec3(0.815, 0.865, 0.905);
const vec3 kZenith = vec3(0.265, 0.480, 0.765);
vec3 skyColour(vec3 d) { return mix(kHorizon, kZenith, pow(clamp(d.z, 0.0, 1.0), 0.62)); }
)";

inline constexpr const char* kBodyVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
out vec3 normalW, positionW, eyeW;
out vec4 colour, glow;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    positionW = (osg_ViewMatrixInverse * eye).xyz;
    normalW = mat3(osg_ViewMatrixInverse) * (gl_NormalMatrix * gl_Normal);
    eyeW = osg_ViewMatrixInverse[3].xyz;
    colour = gl_Color;
    glow = gl_MultiTexCoord1;
    gl_Position = gl_ProjectionMatrix * eye;
    // Of faces in one plane the one in the higher layer wins, in every view.
    gl_Position.z -= gl_MultiTexCoord2.x * 9.0e-7 * gl_Position.w;
}
)";

inline constexpr const char* kBodyFragment = R"(
uniform float groundHeight;
in vec3 normalW, positionW, eyeW;
in vec4 colour, glow;
out vec4 fragment;
void main() {
    vec3 n = normalize(gl_FrontFacing ? normalW : -normalW);
    vec3 v = normalize(eyeW - positionW);
    float sun = max(dot(n, kSun), 0.0);
    vec3 ambient = mix(kGroundLight, kSkyLight, 0.5 + 0.5 * n.z);
    // Near the ground less of the sky is seen.
    ambient *= 1.0 - (0.62 - 0.38 * n.z) * 0.55 * exp(-max(positionW.z - groundHeight, 0.0) * 11.0);
    vec3 albedo = colour.rgb * colour.rgb;
    vec3 light = albedo * (ambient + kSunLight * sun);
    // A dull sheen for everything, a highlight for what is polished.
    float lit = 1.0 - min(dot(glow.rgb, vec3(1.0)), 1.0);
    float rim = 1.0 - max(dot(n, v), 0.0);
    float sheen = ((0.042 + 0.10 * glow.a) + (0.10 + 0.5 * glow.a) * rim * rim * rim * rim) * min(1.0 + n.z, 1.0);
    vec3 r = reflect(-v, n);
    light += lit * sheen * mix(kGroundLight, kHorizon * kHorizon, smoothstep(-0.25, 0.35, r.z));
    float exponent = mix(14.0, 110.0, glow.a);
    float spot = pow(max(dot(n, normalize(kSun + v)), 0.0), exponent) * sun;
    light += lit * kSunLight * spot * mix(0.07, 0.85, glow.a);
    light += glow.rgb * glow.rgb;
    fragment = vec4(sqrt(light), colour.a);
}
)";

/// The last whole drawing of what the text no longer says: grey, its rim clearer than its middle.
inline constexpr const char* kGhostFragment = R"(
uniform float groundHeight;
in vec3 normalW, positionW, eyeW;
in vec4 colour, glow;
out vec4 fragment;
void main() {
    vec3 n = normalize(gl_FrontFacing ? normalW : -normalW);
    float rim = 1.0 - abs(dot(n, normalize(eyeW - positionW)));
    fragment = vec4(vec3(0.46 + 0.24 * n.z), 0.30 + 0.45 * rim * rim);
}
)";

/// One colour; a little nearer than it is, so that it is seen over the surface it lies in.
inline constexpr const char* kFlatVertex = R"(
void main() {
    gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
    gl_Position.z -= 4.0e-6 * gl_Position.w;
}
)";
inline constexpr const char* kFlatFragment = R"(
uniform vec4 flatColour;
out vec4 fragment;
void main() { fragment = flatColour; }
)";

inline constexpr const char* kFloorVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
out vec2 onFloor;
out vec3 fromEye;
void main() {
    onFloor = gl_Vertex.xy;
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    fromEye = mat3(osg_ViewMatrixInverse) * eye.xyz;
    gl_Position = gl_ProjectionMatrix * eye;
}
)";

/// Lines every 10 cm, 1 m and 10 m; each set fades where its lines would crowd. One pixel wide at any distance.
inline constexpr const char* kFloorFragment = R"(
uniform vec3 floorColour;
uniform vec3 floorLight;
uniform float hazeDistance;
in vec2 onFloor;
in vec3 fromEye;
out vec4 fragment;
float lines(vec2 p, vec2 w, float widthPx) {
    vec2 d = abs(fract(p - 0.5) - 0.5) / w;
    vec2 l = clamp(widthPx * 0.5 + 0.5 - d, 0.0, 1.0) * clamp(1.25 - 6.0 * w, 0.0, 1.0);
    return max(l.x, l.y);
}
void main() {
    vec2 w = fwidth(onFloor);
    float fine = lines(onFloor * 10.0, w * 10.0, 1.0);
    float metre = lines(onFloor, w, 1.25);
    float ten = lines(onFloor * 0.1, w * 0.1, 2.0);
    float ink = max(max(fine * 0.13, metre * 0.34), ten * 0.52);
    // Every second metre a shade darker.
    vec2 tile = abs(fract(onFloor * 0.5) - 0.5);
    vec2 edge = clamp((tile - 0.25) / max(w * 0.5, vec2(1e-5)), -0.5, 0.5);
    float checker = edge.x * edge.y * 4.0 * clamp(1.0 - 4.0 * max(w.x, w.y), 0.0, 1.0);
    vec3 albedo = floorColour * floorColour * (1.0 - ink) * (1.0 + 0.030 * checker);
    vec3 shown = sqrt(albedo * floorLight);
    float far = length(fromEye) / hazeDistance;
    fragment = vec4(mix(kHorizon, shown, exp(-far * far)), 1.0);
}
)";

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
in vec3 direction;
out vec4 fragment;
void main() {
    vec3 d = normalize(direction);
    vec3 colour = skyColour(d);
    float near = max(dot(d, kSun), 0.0);
    colour += vec3(0.10, 0.085, 0.06) * pow(near, 24.0);
    // Where there is no floor the ground below fades to grey.
    colour = mix(colour, vec3(0.47, 0.49, 0.51), smoothstep(0.0, 0.5, -d.z));
    fragment = vec4(colour, 1.0);
}
)";

/// Bodies flattened onto a plane along the light. What stands below the plane is cut away: it has no shadow there. Higher
/// than shadowTop nothing is drawn, and up to there the shadow gets fainter.
inline constexpr const char* kShadowVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
uniform mat4 osg_ViewMatrix;
uniform vec4 shadowPlane;
uniform float shadowHeightScale;
uniform float shadowTop;
out float distanceToEye, fade;
void main() {
    vec3 world = (osg_ViewMatrixInverse * (gl_ModelViewMatrix * gl_Vertex)).xyz;
    float height = dot(shadowPlane.xyz, world) - shadowPlane.w;
    gl_ClipDistance[0] = height / shadowHeightScale + 0.003;
    gl_ClipDistance[1] = shadowTop - height / shadowHeightScale;
    fade = 1.0 - height / (shadowHeightScale * shadowTop);
    vec4 eye = osg_ViewMatrix * vec4(world - height * shadowPlane.xyz, 1.0);
    distanceToEye = length(eye.xyz);
    gl_Position = gl_ProjectionMatrix * eye;
}
)";

inline constexpr const char* kShadowFragment = R"(
uniform float hazeDistance;
uniform float shadowDepth;
in float distanceToEye, fade;
out vec4 fragment;
void main() {
    float far = distanceToEye / hazeDistance;
    fragment = vec4(0.02, 0.03, 0.06, shadowDepth * fade * exp(-far * far));
}
)";

} // namespace trundle::shaders
