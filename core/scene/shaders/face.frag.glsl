in vec3 inView;
out vec4 fragment;
void main() {
    vec3 n = cross(dFdx(inView), dFdy(inView));
    float size = length(n);
    n = size > 0.0 ? n / size : vec3(0.0, 0.0, 1.0);
    vec3 way = gl_ProjectionMatrix[2][3] != 0.0 ? inView : vec3(0.0, 0.0, -1.0);
    fragment = vec4(dot(n, way) > 0.0 ? -n : n, -inView.z);
}
