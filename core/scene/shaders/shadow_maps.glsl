// Sun shadows and ambient occlusion of the rich look. Included by every program that shades a surface.
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
// How much of the sun a place sees on a surface with this normal. The further what hides it, the softer the edge.
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
// How much of the sky a place sees.
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
