uniform vec4 flatColour;
out vec4 fragment;
void main() { fragment = flatColour; }
