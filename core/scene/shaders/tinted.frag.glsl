uniform mat4 osg_ViewMatrixInverse;
in vec3 normalW, positionW;
in vec4 colour;
out vec4 fragment;
void main() {
    vec3 n = normalize(normalW);
    float rim = 1.0 - abs(dot(n, normalize(osg_ViewMatrixInverse[3].xyz - positionW)));
    fragment = vec4(colour.rgb * (0.86 + 0.14 * n.z), 0.40 + 0.45 * rim * rim);
}
