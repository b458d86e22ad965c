// Of faces in one plane the one in the higher layer wins, in every view.
vec4 inLayer(vec4 position) {
    position.z -= mod(gl_MultiTexCoord2.x, 4.0) * 9.0e-7 * position.w;
    return position;
}
