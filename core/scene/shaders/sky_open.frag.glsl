// Ambient occlusion: the fraction of the sky that the faces around a point leave open, searched up to `openReach` (m). The
// pattern of directions repeats every four pixels; sky_smooth.frag.glsl averages over it.
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
