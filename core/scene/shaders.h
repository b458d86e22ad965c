#pragma once
// GLSL 1.30 for a compatibility context. Input and output colours are display colours; light is summed linearly, with a gamma of
// 2. No branch depends on a uniform, because software renderers pay for every branch.

namespace trundle::shaders {

/// Shading by the values of Lighting. The number of lamps is compiled in: in software rendering even a loop with no iterations
/// doubles the cost per pixel.
inline constexpr const char* kLight = R"(
#pragma import_defines(LAMPS, SUN_MAP, SKY_MAP)
uniform vec3 sunWay, sunLight, skyLight, groundLight, horizonColour, zenithColour;
#ifdef LAMPS
uniform vec3 lampPlace[LAMPS], lampLight[LAMPS];
/// Of all lamps on a matt surface.
vec3 lampsOn(vec3 place, vec3 n) {
    vec3 all = vec3(0.0);
    for (int i = 0; i < LAMPS; ++i) {
        vec3 way = lampPlace[i] - place;
        float square = max(dot(way, way), 1.0e-4);
        all += lampLight[i] * max(dot(n, way), 0.0) * inversesqrt(square) / square;
    }
    return all;
}
#else
vec3 lampsOn(vec3 place, vec3 n) { return vec3(0.0); }
#endif
vec3 skyColour(vec3 d) { return mix(horizonColour, zenithColour, pow(clamp(d.z, 0.0, 1.0), 0.62)); }
)";

inline constexpr const char* kBodyVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
out vec3 normalW, positionW;
// Of the material, which is the same at all corners of a triangle: how light adds up on it, and what it emits.
flat out vec4 albedo, shine;
flat out vec3 glow;
out vec2 onPicture;
void main() {
    onPicture = gl_MultiTexCoord0.xy;
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    positionW = (osg_ViewMatrixInverse * eye).xyz;
    normalW = mat3(osg_ViewMatrixInverse) * (mat3(gl_ModelViewMatrix) * gl_Normal); // nothing is stretched
    albedo = vec4(gl_Color.rgb * gl_Color.rgb, gl_Color.a);
    glow = gl_MultiTexCoord1.rgb * gl_MultiTexCoord1.rgb;
    // A dull sheen for everything, stronger along the rim, and a highlight for what is polished; none for what shines itself.
    float polish = gl_MultiTexCoord1.a, lit = 1.0 - min(dot(gl_MultiTexCoord1.rgb, vec3(1.0)), 1.0);
    shine = vec4(lit * vec3(0.042 + 0.10 * polish, 0.10 + 0.5 * polish, mix(0.07, 0.85, polish)), mix(20.2, 158.7, polish));
    gl_Position = gl_ProjectionMatrix * eye;
    // Of faces in one plane the one in the higher layer wins, in every view.
    gl_Position.z -= mod(gl_MultiTexCoord2.x, 4.0) * 9.0e-7 * gl_Position.w;
}
)";

/// Depth along the optical axis and object number; same layers as kBodyVertex.
inline constexpr const char* kDataVertex = R"(
uniform float firstObject;
out float depth;
flat out float object;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    depth = -eye.z;
    object = firstObject + gl_MultiTexCoord2.x;
    gl_Position = gl_ProjectionMatrix * eye;
    gl_Position.z -= mod(gl_MultiTexCoord2.x, 4.0) * 9.0e-7 * gl_Position.w;
}
)";
inline constexpr const char* kDataFragment = R"(
in float depth;
flat in float object;
out vec4 fragment;
void main() { fragment = vec4(depth, object, 0.0, 1.0); }
)";

inline constexpr const char* kBodyFragment = R"(
uniform float groundHeight;
uniform mat4 osg_ViewMatrixInverse;
in vec3 normalW, positionW;
flat in vec4 albedo, shine;
flat in vec3 glow;
#ifdef PICTURED
in vec2 onPicture;
uniform sampler2D picture;
#endif
out vec4 fragment;
void main() {
    vec3 n = normalize(gl_FrontFacing ? normalW : -normalW);
    vec3 v = normalize(osg_ViewMatrixInverse[3].xyz - positionW);
    float toSun = dot(n, sunWay), toEye = dot(n, v), sun = max(toSun, 0.0);
    vec3 ambient = mix(groundLight, skyLight, 0.5 + 0.5 * n.z);
#ifdef SKY_MAP
    ambient *= skySeen(positionW);
#else
    // Near the ground less of the sky is seen.
    ambient *= 1.0 - (0.341 - 0.209 * n.z) * exp2(-15.87 * max(positionW.z - groundHeight, 0.0));
#endif
#ifdef SUN_MAP
    sun *= sunSeen(positionW, n);
#endif
    vec3 own = albedo.rgb;
#ifdef PICTURED
    vec3 shown = texture(picture, onPicture).rgb;
    own = shown * shown;
#endif
    vec3 light = own * (ambient + sunLight * sun + lampsOn(positionW, n)) + glow;
    // What is reflected: ground below, horizon above.
    float rim = 1.0 - max(toEye, 0.0);
    rim *= rim;
    float sheen = (shine.x + shine.y * rim * rim) * min(1.0 + n.z, 1.0);
    float up = clamp((2.0 * toEye * n.z - v.z) * 1.6667 + 0.41667, 0.0, 1.0);
    light += sheen * mix(groundLight, horizonColour * horizonColour, up * up * (3.0 - 2.0 * up));
    // The sun, by how far the normal is from the middle between its way and the eye's.
    float spread = (toSun + toEye) * inversesqrt(max(2.0 + 2.0 * dot(sunWay, v), 1e-4));
    light += sunLight * (shine.z * sun * exp2(shine.w * (spread - 1.0)));
    fragment = vec4(sqrt(light), albedo.a);
}
)";

/// Ghost of an object that is no longer resolved: grey, more visible at its silhouette.
inline constexpr const char* kGhostFragment = R"(
uniform mat4 osg_ViewMatrixInverse;
in vec3 normalW, positionW;
out vec4 fragment;
void main() {
    vec3 n = normalize(gl_FrontFacing ? normalW : -normalW);
    float rim = 1.0 - abs(dot(n, normalize(osg_ViewMatrixInverse[3].xyz - positionW)));
    fragment = vec4(vec3(0.60 + 0.32 * n.z), 0.55 + 0.40 * rim * rim); // apart from a grey floor too
}
)";

/// Overlay shape with interpolated vertex colours; most transparent where the line of sight grazes it.
inline constexpr const char* kTintedVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
out vec3 normalW, positionW;
out vec4 colour;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    positionW = (osg_ViewMatrixInverse * eye).xyz;
    normalW = mat3(osg_ViewMatrixInverse) * (mat3(gl_ModelViewMatrix) * gl_Normal);
    colour = gl_Color;
    gl_Position = gl_ProjectionMatrix * eye;
}
)";
inline constexpr const char* kTintedFragment = R"(
uniform mat4 osg_ViewMatrixInverse;
in vec3 normalW, positionW;
in vec4 colour;
out vec4 fragment;
void main() {
    vec3 n = normalize(normalW);
    float rim = 1.0 - abs(dot(n, normalize(osg_ViewMatrixInverse[3].xyz - positionW)));
    fragment = vec4(colour.rgb * (0.86 + 0.14 * n.z), 0.40 + 0.45 * rim * rim);
}
)";

/// One colour, with a small depth offset so that it is visible over the surface it lies in.
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

} // namespace trundle::shaders
