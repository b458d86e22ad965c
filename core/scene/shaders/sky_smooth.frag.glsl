// Mean over 4 x 4 pixels, restricted to pixels at a similar distance.
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
