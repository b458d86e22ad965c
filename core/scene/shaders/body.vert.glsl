#include "layers.glsl"
#include "surface.glsl"
// Of the material, which is the same at all corners of a triangle: how light adds up on it, and what it emits.
flat out vec4 albedo, shine;
flat out vec3 glow;
out vec2 onPicture;
void main() {
    onPicture = gl_MultiTexCoord0.xy;
    vec4 eye = placeSurface();
    albedo = vec4(gl_Color.rgb * gl_Color.rgb, gl_Color.a);
    glow = gl_MultiTexCoord1.rgb * gl_MultiTexCoord1.rgb;
    // A dull sheen for everything, stronger along the rim, and a highlight for what is polished; none for what shines itself.
    float polish = gl_MultiTexCoord1.a, lit = 1.0 - min(dot(gl_MultiTexCoord1.rgb, vec3(1.0)), 1.0);
    shine = vec4(lit * vec3(0.042 + 0.10 * polish, 0.10 + 0.5 * polish, mix(0.07, 0.85, polish)), mix(20.2, 158.7, polish));
    gl_Position = inLayer(gl_ProjectionMatrix * eye);
}
