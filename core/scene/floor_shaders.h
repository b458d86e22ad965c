#pragma once
// GLSL programs of floors; conventions as in shaders.h.

namespace trundle::shaders {

/// Light on a floor in the rich look.
inline constexpr const char* kFloorLight = R"(
uniform vec3 floorLight, floorNormal;
#if defined(SUN_MAP) || defined(SKY_MAP)
#define LIGHT_VARIES
vec3 floorLightAt(vec3 place) {
    vec3 ambient = mix(groundLight, skyLight, 0.5 + 0.5 * floorNormal.z), sun = sunLight * max(dot(floorNormal, sunWay), 0.0);
#ifdef SKY_MAP
    ambient *= skySeen(place);
#endif
#ifdef SUN_MAP
    sun *= sunSeen(place, floorNormal);
#endif
    return ambient + sun + lampsOn(place, floorNormal);
}
#endif
)";

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

/// Lines every 10 cm, 1 m and 10 m, one pixel wide at any distance; each set fades out where its lines would get too dense.
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
uniform float floorLines;
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
    float left = (1.0 - ink * floorLines) * (1.0 + 0.120 * checker * floorLines); // of the floor's own colour
#ifdef LIGHT_VARIES
    vec3 shown = floorColour * sqrt(left * floorLightAt(positionW));
#elif defined(LAMPS)
    vec3 shown = floorColour * sqrt(left * (floorLight + lampsOn(positionW, floorNormal)));
#else
    vec3 shown = floorShown * sqrt(left);
#endif
    fragment = vec4(mix(horizonColour, shown, exp2(-dot(inHaze, inHaze))), 1.0);
}
)";

/// The grid lines alone.
inline constexpr const char* kGuideFragment = R"(
in vec2 onFloor;
in vec3 inHaze;
out vec4 fragment;
void main() {
    vec2 w = max(fwidth(onFloor), vec2(1e-6));
    fragment = vec4(0.13, 0.15, 0.18, gridInk(onFloor, w, 1.0 / w) * exp2(-dot(inHaze, inHaze)));
}
)";

/// A texture instead of grid lines; `pictureScale` repetitions per metre.
inline constexpr const char* kPicturedFloorFragment = R"(
uniform sampler2D picture;
uniform float pictureScale;
in vec2 onFloor;
in vec3 inHaze, positionW;
out vec4 fragment;
void main() {
    vec3 colour = texture(picture, vec2(onFloor.x, -onFloor.y) * pictureScale).rgb;
#ifdef LIGHT_VARIES
    vec3 shown = sqrt(colour * colour * floorLightAt(positionW));
#else
    vec3 shown = sqrt(colour * colour * (floorLight + lampsOn(positionW, floorNormal)));
#endif
    fragment = vec4(mix(horizonColour, shown, exp2(-dot(inHaze, inHaze))), 1.0);
}
)";

/// A translucent image over a part of a floor, blended over everything drawn there.
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

} // namespace trundle::shaders
