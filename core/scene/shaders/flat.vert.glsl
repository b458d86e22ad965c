// One colour, with a small depth offset so that it is visible over the surface it lies in.
void main() {
    gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
    gl_Position.z -= 4.0e-6 * gl_Position.w;
}
