#include "light.glsl"
#include "shadow_maps.glsl"
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
    vec3 light = own * (ambient + sunLight * sun + lampsOn(positionW, n) + ledsOn(positionW, n)) + glow;
    // What is reflected: ground below, horizon above.
    float rim = 1.0 - max(toEye, 0.0);
    rim *= rim;
    float sheen = (shine.x + shine.y * rim * rim) * min(1.0 + n.z, 1.0);
    float up = clamp((2.0 * toEye * n.z - v.z) * 1.6667 + 0.41667, 0.0, 1.0);
    light += sheen * mix(groundLight, horizonShine, up * up * (3.0 - 2.0 * up));
    // The sun, by how far the normal is from the middle between its way and the eye's.
    float spread = (toSun + toEye) * inversesqrt(max(2.0 + 2.0 * dot(sunWay, v), 1e-4));
    light += sunLight * (shine.z * sun * exp2(shine.w * (spread - 1.0)));
    fragment = vec4(sqrt(light), albedo.a);
}
