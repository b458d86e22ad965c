#pragma once
// GLSL 1.30 for a compatibility context. Colours enter and leave as shown on a screen; light is added up linearly, with a
// square for the screen's curve. No branch depends on a uniform: software renderers pay for every branch.

namespace trundle::shaders {

/// What Lighting tells. The programs are made for one number of lamps: in software a loop that could be entered costs every
/// pixel twice the time, also where it is not.
inline constexpr const char* kLight = R"(
#pragma import_defines(LAMPS)
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
out vec3 normalW, positionW, eyeW;
out vec4 colour, glow;
out vec2 onPicture;
void main() {
    onPicture = gl_MultiTexCoord0.xy;
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    positionW = (osg_ViewMatrixInverse * eye).xyz;
    normalW = mat3(osg_ViewMatrixInverse) * (gl_NormalMatrix * gl_Normal);
    eyeW = osg_ViewMatrixInverse[3].xyz;
    colour = gl_Color;
    glow = gl_MultiTexCoord1;
    gl_Position = gl_ProjectionMatrix * eye;
    // Of faces in one plane the one in the higher layer wins, in every view.
    gl_Position.z -= mod(gl_MultiTexCoord2.x, 4.0) * 9.0e-7 * gl_Position.w;
}
)";

/// Distance along the line of sight, and which object it is; in the layers of kBodyVertex.
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
in vec3 normalW, positionW, eyeW;
in vec4 colour, glow;
#ifdef PICTURED
in vec2 onPicture;
uniform sampler2D picture;
#endif
out vec4 fragment;
void main() {
    vec3 n = normalize(gl_FrontFacing ? normalW : -normalW);
    vec3 v = normalize(eyeW - positionW);
    float sun = max(dot(n, sunWay), 0.0);
    vec3 ambient = mix(groundLight, skyLight, 0.5 + 0.5 * n.z);
    // Near the ground less of the sky is seen.
    ambient *= 1.0 - (0.62 - 0.38 * n.z) * 0.55 * exp(-max(positionW.z - groundHeight, 0.0) * 11.0);
    vec3 shown = colour.rgb;
#ifdef PICTURED
    shown = texture(picture, onPicture).rgb;
#endif
    vec3 albedo = shown * shown;
    vec3 light = albedo * (ambient + sunLight * sun + lampsOn(positionW, n));
    // A dull sheen for everything, a highlight for what is polished.
    float lit = 1.0 - min(dot(glow.rgb, vec3(1.0)), 1.0);
    float rim = 1.0 - max(dot(n, v), 0.0);
    float sheen = ((0.042 + 0.10 * glow.a) + (0.10 + 0.5 * glow.a) * rim * rim * rim * rim) * min(1.0 + n.z, 1.0);
    vec3 r = reflect(-v, n);
    light += lit * sheen * mix(groundLight, horizonColour * horizonColour, smoothstep(-0.25, 0.35, r.z));
    float exponent = mix(14.0, 110.0, glow.a);
    float spot = pow(max(dot(n, normalize(sunWay + v)), 0.0), exponent) * sun;
    light += lit * sunLight * spot * mix(0.07, 0.85, glow.a);
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

} // namespace trundle::shaders
