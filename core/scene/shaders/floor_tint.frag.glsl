// A translucent image over a part of a floor, blended over everything drawn there.
uniform sampler2D picture;
uniform vec4 pictureArea;
in vec2 onFloor;
in vec3 inHaze;
out vec4 fragment;
void main() {
    vec4 tint = texture(picture, (onFloor - pictureArea.xy) * pictureArea.zw);
    fragment = vec4(tint.rgb, tint.a * exp2(-dot(inHaze, inHaze)));
}
