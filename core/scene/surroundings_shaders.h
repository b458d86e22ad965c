#pragma once
// The programs of what surrounds the bodies: floors, sky and shadows. As shaders.h.

namespace trundle::shaders {

inline constexpr const char* kFloorVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
uniform float hazeDistance;
uniform vec3 floorColour, floorLight;
out vec2 onFloor;
out vec3 inHaze, positionW; // how far away it is: the haze leaves exp2(-dot(inHaze, inHaze)) of it
flat out vec3 floorShown;   // where there are no lamps
void main() {
    onFloor = gl_Vertex.xy;
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    positionW = (osg_ViewMatrixInverse * eye).xyz;
    inHaze = eye.xyz * (1.2011224 / hazeDistance);
    floorShown = floorColour * sqrt(floorLight);
    gl_Position = gl_ProjectionMatrix * eye;
}
)";

/// Lines every 10 cm, 1 m and 10 m; each set fades where its lines would crowd. One pixel wide at any distance.
inline constexpr const char* kGridLines = R"(
/// Of all whole numbers, where `pixels` are from one to the next.
float lines(vec2 p, vec2 pixels, vec2 fade, float widthPx) {
    vec2 l = clamp(widthPx * 0.5 + 0.5 - abs(p - roundEven(p)) * pixels, 0.0, 1.0) * clamp(fade, 0.0, 1.0);
    return max(l.x, l.y);
}
/// At a place where a pixel is `w` wide and a metre so many `pixels`.
float gridInk(vec2 p, vec2 w, vec2 pixels) {
    float fine = lines(p * 10.0, pixels * 0.1, 1.25 - 60.0 * w, 1.0);
    float metre = lines(p, pixels, 1.25 - 6.0 * w, 1.25);
    float ten = lines(p * 0.1, pixels * 10.0, 1.25 - 0.6 * w, 2.0);
    return max(max(fine * 0.13, metre * 0.34), ten * 0.52);
}
)";

inline constexpr const char* kFloorFragment = R"(
uniform vec3 floorColour;
uniform vec3 floorLight, floorNormal;
in vec2 onFloor;
in vec3 inHaze, positionW;
flat in vec3 floorShown;
out vec4 fragment;
void main() {
    vec2 w = max(fwidth(onFloor), vec2(1e-6));
    vec2 pixels = 1.0 / w;
    float ink = gridInk(onFloor, w, pixels);
    // Every second metre a shade darker.
    vec2 tile = abs(fract(onFloor * 0.5) - 0.5);
    vec2 edge = clamp((tile - 0.25) * (2.0 * pixels), -0.5, 0.5);
    float checker = edge.x * edge.y * clamp(1.0 - 4.0 * max(w.x, w.y), 0.0, 1.0);
    float left = (1.0 - ink) * (1.0 + 0.120 * checker); // of the floor's own colour
#ifdef LAMPS
    vec3 shown = floorColour * sqrt(left * (floorLight + lampsOn(positionW, floorNormal)));
#else
    vec3 shown = floorShown * sqrt(left);
#endif
    fragment = vec4(mix(horizonColour, shown, exp2(-dot(inHaze, inHaze))), 1.0);
}
)";

/// The lines alone.
inline constexpr const char* kGuideFragment = R"(
in vec2 onFloor;
in vec3 inHaze;
out vec4 fragment;
void main() {
    vec2 w = max(fwidth(onFloor), vec2(1e-6));
    fragment = vec4(0.13, 0.15, 0.18, gridInk(onFloor, w, 1.0 / w) * exp2(-dot(inHaze, inHaze)));
}
)";

/// A picture in place of lines: `pictureScale` of it on each metre.
inline constexpr const char* kPicturedFloorFragment = R"(
uniform sampler2D picture;
uniform float pictureScale;
uniform vec3 floorLight, floorNormal;
in vec2 onFloor;
in vec3 inHaze, positionW;
out vec4 fragment;
void main() {
    vec3 colour = texture(picture, vec2(onFloor.x, -onFloor.y) * pictureScale).rgb;
    vec3 shown = sqrt(colour * colour * (floorLight + lampsOn(positionW, floorNormal)));
    fragment = vec4(mix(horizonColour, shown, exp2(-dot(inHaze, inHaze))), 1.0);
}
)";

/// A picture over a part of a floor, on whatever is drawn there.
inline constexpr const char* kFloorTintFragment = R"(
uniform sampler2D picture;
uniform vec4 pictureArea;
in vec2 onFloor;
in vec3 inHaze;
out vec4 fragment;
void main() {
    vec4 tint = texture(picture, (onFloor - pictureArea.xy) * pictureArea.zw);
    fragment = vec4(tint.rgb, tint.a * exp2(-dot(inHaze, inHaze)));
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
    near *= near * near;
    near *= near;
    near *= near;
    colour += vec3(0.10, 0.085, 0.06) * (near * near); // to the power of 24
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
uniform float hazeDistance;
out float inHaze, fade;
void main() {
    vec3 world = (osg_ViewMatrixInverse * (gl_ModelViewMatrix * gl_Vertex)).xyz;
    float height = dot(shadowPlane.xyz, world) - shadowPlane.w;
    gl_ClipDistance[0] = height / shadowHeightScale + 0.003;
    gl_ClipDistance[1] = shadowTop - height / shadowHeightScale;
    fade = 1.0 - height / (shadowHeightScale * shadowTop);
    vec4 eye = osg_ViewMatrix * vec4(world - height * shadowPlane.xyz, 1.0);
    inHaze = length(eye.xyz) * (1.2011224 / hazeDistance);
    gl_Position = gl_ProjectionMatrix * eye;
}
)";

inline constexpr const char* kShadowFragment = R"(
uniform float shadowDepth;
in float inHaze, fade;
out vec4 fragment;
void main() { fragment = vec4(0.02, 0.03, 0.06, shadowDepth * fade * exp2(-inHaze * inHaze)); }
)";

/// The same from a lamp. A place on the floor is kept undivided, so that what is higher than the lamp can be cut away before; what is
/// nearer to the lamp than 10 cm is a part of it.
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
