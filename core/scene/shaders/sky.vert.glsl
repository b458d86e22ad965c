uniform mat4 osg_ViewMatrixInverse;
out vec3 direction;
void main() {
    vec4 p = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    // A parallel projection has one direction only; its rays differ in where they start.
    direction = mat3(osg_ViewMatrixInverse) * mix(vec3(0.0, 0.0, -1.0), p.xyz / p.w, gl_ProjectionMatrix[2][3] != 0.0 ? 1.0 : 0.0);
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
}
