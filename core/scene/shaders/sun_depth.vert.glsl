// Shadow map of the sun. Transparent surfaces skip some pixels of the map; after blurring they cast a lighter shadow.
flat out float opacity;
void main() {
    opacity = gl_Color.a;
    gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
}
