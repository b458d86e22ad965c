#pragma once
// GLSL programs of the rich look, and its additions to shaders.h. Same conventions, but written for graphics cards.

namespace trundle::shaders {

/// Appended to kLight in every program that shades a surface.
inline constexpr const char* kRichLight = R"(
#ifdef SUN_MAP
uniform sampler2DShadow sunTests;
uniform sampler2D sunDepths;
uniform mat4 sunMap;   // from the world to the map, all from 0 to 1
uniform vec4 sunSize;  // of it (m), and of one of its pixels
const vec2 disc[32] = vec2[32](
    vec2(0.1250, 0.0000), vec2(-0.1596, 0.1462), vec2(0.0244, -0.2784), vec2(0.2012, 0.2625), vec2(-0.3693, -0.0653),
    vec2(0.3498, -0.2225), vec2(-0.1170, 0.4352), vec2(-0.2231, -0.4296), vec2(0.4841, 0.1768), vec2(-0.5036, 0.2079),
    vec2(0.2428, -0.5188), vec2(0.1794, 0.5720), vec2(-0.5408, -0.3134), vec2(0.6344, -0.1395), vec2(-0.3871, 0.5507),
    vec2(-0.0894, -0.6902), vec2(0.5491, 0.4628), vec2(-0.7389, 0.0306), vec2(0.5390, -0.5363), vec2(-0.0361, 0.7798),
    vec2(-0.5128, -0.6145), vec2(0.8124, 0.1093), vec2(-0.6883, 0.4789), vec2(0.1881, -0.8361), vec2(0.4350, 0.7592),
    vec2(-0.8504, -0.2713), vec2(0.8261, -0.3817), vec2(-0.3579, 0.8552), vec2(-0.3194, -0.8880), vec2(0.8499, 0.4467),
    vec2(-0.9440, 0.2488), vec2(0.5366, -0.8345));
/// How much of the sun a place sees on a surface with this normal. The further what hides it, the softer the edge.
float sunSeen(vec3 place, vec3 n) {
    // The map is no finer than its pixels: from a little above the surface it does not hide itself.
    vec3 at = (sunMap * vec4(place + n * (1.5 * sunSize.w), 1.0)).xyz, tilt = mat3(sunMap) * n * sunSize.xyz;
    // Beside the place the surface goes up or down with its tilt.
    vec2 rise = tilt.xy * sunSize.xy / (max(-tilt.z, 0.05) * sunSize.z);
    at.z = min(at.z, 1.0) - 0.7 * sunSize.w / sunSize.z;
    vec2 pixel = sunSize.w / sunSize.xy;
    float reach = clamp(0.034 * at.z * sunSize.z / sunSize.w, 2.0, 10.0);
    float hidden = 0.0, above = 0.0;
    for (int i = 0; i < 32; i += 2) {
        vec2 off = disc[i] * reach * pixel;
        float higher = at.z + dot(off, rise) - texture(sunDepths, at.xy + off).r;
        hidden += higher > 0.0 ? 1.0 : 0.0;
        above += max(higher, 0.0);
    }
    float blur = clamp(0.034 * above / max(hidden, 1.0) * sunSize.z / sunSize.w, 1.5, 10.0);
    float seen = 0.0;
    for (int i = 0; i < 32; ++i) {
        vec2 off = disc[i] * blur * pixel;
        seen += texture(sunTests, vec3(at.xy + off, at.z + dot(off, rise)));
    }
    return seen / 32.0;
}
#endif
#ifdef SKY_MAP
uniform sampler2D skyMap; // how open, and how far away
uniform mat4 osg_ViewMatrix;
/// How much of the sky a place sees.
float skySeen(vec3 place) {
    float far = -(osg_ViewMatrix * vec4(place, 1.0)).z;
    ivec2 here = ivec2(gl_FragCoord.xy), most = textureSize(skyMap, 0) - 1;
    vec2 sum = vec2(1.0e-3); // of what is not on the map, as glass, nothing hides the sky
    // At the edge of a thing the middle of the pixel may belong to another one: the neighbours that are as far away count.
    for (int i = 0; i < 5; ++i) {
        ivec2 off = i == 0 ? ivec2(0) : ivec2((i & 1) * (2 - i), ((i + 1) & 1) * (3 - i));
        vec2 there = texelFetch(skyMap, clamp(here + off, ivec2(0), most), 0).rg;
        sum += vec2(there.r, 1.0) * max(1.0 - abs(there.g - far) / (0.03 * far), 0.0);
    }
    return sum.x / sum.y;
}
#endif
)";

/// Shadow map of the sun. Transparent surfaces skip some pixels of the map; after blurring they cast a lighter shadow.
inline constexpr const char* kSunVertex = R"(
flat out float opacity;
void main() {
    opacity = gl_Color.a;
    gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
}
)";
inline constexpr const char* kSunFragment = R"(
flat in float opacity;
out vec4 fragment;
void main() {
    ivec2 cell = ivec2(gl_FragCoord.xy) & 1;
    if (opacity < 0.125 + 0.25 * float((cell.x * 2) ^ (cell.y * 3))) discard;
    fragment = vec4(gl_FragCoord.z);
}
)";

/// Normal of the visible face towards the eye, and its distance.
inline constexpr const char* kFaceVertex = R"(
out vec3 inView;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    inView = eye.xyz;
    gl_Position = gl_ProjectionMatrix * eye;
    gl_Position.z -= mod(gl_MultiTexCoord2.x, 4.0) * 9.0e-7 * gl_Position.w;
}
)";
inline constexpr const char* kFaceFragment = R"(
in vec3 inView;
out vec4 fragment;
void main() {
    vec3 n = cross(dFdx(inView), dFdy(inView));
    float size = length(n);
    n = size > 0.0 ? n / size : vec3(0.0, 0.0, 1.0);
    vec3 way = gl_ProjectionMatrix[2][3] != 0.0 ? inView : vec3(0.0, 0.0, -1.0);
    fragment = vec4(dot(n, way) > 0.0 ? -n : n, -inView.z);
}
)";

inline constexpr const char* kWholeVertex = R"(
void main() { gl_Position = vec4(gl_Vertex.xy, 0.0, 1.0); }
)";

/// Ambient occlusion: the fraction of the sky that the faces around a point leave open, searched up to `openReach` (m). The
/// pattern of directions repeats every four pixels; kSmoothFragment averages over it.
inline constexpr const char* kOpenFragment = R"(
uniform sampler2D faces;
uniform float openReach;
out vec4 fragment;
vec3 placeAt(vec2 pixel, vec2 size, float far) {
    vec2 on = (2.0 * pixel / size - 1.0) / vec2(gl_ProjectionMatrix[0][0], gl_ProjectionMatrix[1][1]);
    return vec3(on * (gl_ProjectionMatrix[2][3] != 0.0 ? far : 1.0), -far);
}
void main() {
    vec2 size = vec2(textureSize(faces, 0));
    vec4 face = texelFetch(faces, ivec2(gl_FragCoord.xy), 0);
    vec3 place = placeAt(gl_FragCoord.xy, size, face.w);
    float pixels = 0.5 * size.x * gl_ProjectionMatrix[0][0] / (gl_ProjectionMatrix[2][3] != 0.0 ? max(face.w, 1.0e-3) : 1.0);
    float reach = min(openReach * pixels, 0.09 * size.x), within = reach / pixels;
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    float turn = 0.3926991 * float(((cell.x + 4 * cell.y) * 7) & 15);
    float closed = 0.0;
    for (int i = 0; i < 16; ++i) {
        float angle = turn + 2.3999632 * float(i);
        vec2 pixel = floor(gl_FragCoord.xy + reach * (float(i) + 0.5) / 16.0 * vec2(cos(angle), sin(angle))) + 0.5;
        bool inside = all(greaterThan(pixel, vec2(0.0))) && all(lessThan(pixel, size));
        float far = texelFetch(faces, clamp(ivec2(pixel), ivec2(0), ivec2(size) - 1), 0).w;
        vec3 way = placeAt(pixel, size, far) - place;
        float square = dot(way, way), near = max(1.0 - square / (within * within), 0.0);
        float height = dot(way, face.xyz) * inversesqrt(square + 1.0e-9) - 0.12;
        closed += inside && far > 0.0 ? max(height, 0.0) * near : 0.0;
    }
    float open = face.w > 0.0 && reach > 1.5 ? clamp(1.0 - closed * (3.0 / 16.0), 0.0, 1.0) : 1.0;
    fragment = vec4(open, face.w, 0.0, 1.0);
}
)";

/// Mean over 4 x 4 pixels, restricted to pixels at a similar distance.
inline constexpr const char* kSmoothFragment = R"(
uniform sampler2D opened;
out vec4 fragment;
void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), most = textureSize(opened, 0) - 1;
    float far = texelFetch(opened, here, 0).g;
    vec2 sum = vec2(0.0);
    for (int y = -2; y < 2; ++y) {
        for (int x = -2; x < 2; ++x) {
            vec2 there = texelFetch(opened, clamp(here + ivec2(x, y), ivec2(0), most), 0).rg;
            sum += vec2(there.r, 1.0) * max(1.0 - abs(there.g - far) / (0.02 * far + 1.0e-4), 1.0e-4);
        }
    }
    fragment = vec4(sum.x / sum.y, far, 0.0, 1.0);
}
)";

} // namespace trundle::shaders
