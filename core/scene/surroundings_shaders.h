#pragma once
// The programs of what surrounds the bodies: floors, sky and shadows. As shaders.h.

namespace trundle::shaders {

inline constexpr const char* kFloorVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
out vec2 onFloor;
out vec3 fromEye, positionW;
void main() {
    onFloor = gl_Vertex.xy;
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    positionW = (osg_ViewMatrixInverse * eye).xyz;
    fromEye = mat3(osg_ViewMatrixInverse) * eye.xyz;
    gl_Position = gl_ProjectionMatrix * eye;
}
)";

/// Lines every 10 cm, 1 m and 10 m; each set fades where its lines would crowd. One pixel wide at any distance.
inline constexpr const char* kGridLines = R"(
float lines(vec2 p, vec2 w, float widthPx) {
    vec2 d = abs(fract(p - 0.5) - 0.5) / w;
    vec2 l = clamp(widthPx * 0.5 + 0.5 - d, 0.0, 1.0) * clamp(1.25 - 6.0 * w, 0.0, 1.0);
    return max(l.x, l.y);
}
float gridInk(vec2 p, vec2 w) {
    float fine = lines(p * 10.0, w * 10.0, 1.0);
    float metre = lines(p, w, 1.25);
    float ten = lines(p * 0.1, w * 0.1, 2.0);
    return max(max(fine * 0.13, metre * 0.34), ten * 0.52);
}
)";

inline constexpr const char* kFloorFragment = R"(
uniform vec3 floorColour;
uniform vec3 floorLight, floorNormal;
uniform float hazeDistance;
in vec2 onFloor;
in vec3 fromEye, positionW;
out vec4 fragment;
void main() {
    vec2 w = fwidth(onFloor);
    float ink = gridInk(onFloor, w);
    // Every second metre a shade darker.
    vec2 tile = abs(fract(onFloor * 0.5) - 0.5);
    vec2 edge = clamp((tile - 0.25) / max(w * 0.5, vec2(1e-5)), -0.5, 0.5);
    float checker = edge.x * edge.y * 4.0 * clamp(1.0 - 4.0 * max(w.x, w.y), 0.0, 1.0);
    vec3 albedo = floorColour * floorColour * (1.0 - ink) * (1.0 + 0.030 * checker);
    vec3 shown = sqrt(albedo * (floorLight + lampsOn(positionW, floorNormal)));
    float far = length(fromEye) / hazeDistance;
    fragment = vec4(mix(horizonColour, shown, exp(-far * far)), 1.0);
}
)";

/// The lines alone.
inline constexpr const char* kGuideFragment = R"(
uniform float hazeDistance;
in vec2 onFloor;
in vec3 fromEye, positionW;
out vec4 fragment;
void main() {
    float far = length(fromEye) / hazeDistance;
    fragment = vec4(0.13, 0.15, 0.18, gridInk(onFloor, fwidth(onFloor)) * exp(-far * far));
}
)";

/// A picture in place of lines: `pictureScale` of it on each metre.
inline constexpr const char* kPicturedFloorFragment = R"(
uniform sampler2D picture;
uniform float pictureScale;
uniform vec3 floorLight, floorNormal;
uniform float hazeDistance;
in vec2 onFloor;
in vec3 fromEye, positionW;
out vec4 fragment;
void main() {
    vec3 colour = texture(picture, vec2(onFloor.x, -onFloor.y) * pictureScale).rgb;
    vec3 shown = sqrt(colour * colour * (floorLight + lampsOn(positionW, floorNormal)));
    float far = length(fromEye) / hazeDistance;
    fragment = vec4(mix(horizonColour, shown, exp(-far * far)), 1.0);
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
    float near = max(dot(d, sunWay), 0.0);
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
