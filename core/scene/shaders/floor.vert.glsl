uniform mat4 osg_ViewMatrixInverse;
uniform float hazeDistance;
uniform vec3 floorColour, floorLight;
out vec2 onFloor;
out vec3 inHaze, positionW; // how far away it is: the haze leaves exp2(-dot(inHaze, inHaze)) of it
flat out vec3 floorShown;   // where there are no lamps
void main() {
    onFloor = gl_Vertex.xy;
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    positionW = (osg_ViewMatrixInverse * eye).xyz;
    inHaze = eye.xyz * (1.2011224 / hazeDistance);
    floorShown = floorColour * sqrt(floorLight);
    gl_Position = gl_ProjectionMatrix * eye;
}
