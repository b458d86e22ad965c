// Position and normal of a vertex in the world, for the fragment shader.
uniform mat4 osg_ViewMatrixInverse;
out vec3 normalW, positionW;
// Sets both; returns the position in the frame of the eye.
vec4 placeSurface() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    positionW = (osg_ViewMatrixInverse * eye).xyz;
    normalW = mat3(osg_ViewMatrixInverse) * (mat3(gl_ModelViewMatrix) * gl_Normal); // nothing is stretched
    return eye;
}
