// Ghost of an object that is no longer resolved: grey, more visible at its silhouette.
uniform mat4 osg_ViewMatrixInverse;
in vec3 normalW, positionW;
out vec4 fragment;
void main() {
    vec3 n = normalize(gl_FrontFacing ? normalW : -normalW);
    float rim = 1.0 - abs(dot(n, normalize(osg_ViewMatrixInverse[3].xyz - positionW)));
    fragment = vec4(vec3(0.60 + 0.32 * n.z), 0.55 + 0.40 * rim * rim); // apart from a grey floor too
}
