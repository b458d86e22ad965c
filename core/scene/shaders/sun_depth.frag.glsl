flat in float opacity;
out vec4 fragment;
void main() {
    ivec2 cell = ivec2(gl_FragCoord.xy) & 1;
    if (opacity < 0.125 + 0.25 * float((cell.x * 2) ^ (cell.y * 3))) discard;
    fragment = vec4(gl_FragCoord.z);
}
