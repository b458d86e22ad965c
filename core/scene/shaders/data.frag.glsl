in float depth;
flat in float object;
out vec4 fragment;
void main() { fragment = vec4(depth, object, 0.0, 1.0); }
