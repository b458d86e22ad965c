// Shading by the values of Lighting and LedLights. The numbers of lamps and Leds are compiled in: in software rendering even a loop
// with no iterations doubles the cost per pixel.
#pragma import_defines(LAMPS, LEDS, LED_BEAMS, SUN_MAP, SKY_MAP)
uniform vec3 sunWay, sunLight, skyLight, groundLight, horizonColour, zenithColour, horizonShine;
// What a lamp adds to a matt surface; `way` leads to it.
vec3 lampOn(vec3 light, vec3 way, vec3 n) {
    float square = max(dot(way, way), 1.0e-4);
    return light * max(dot(n, way), 0.0) * inversesqrt(square) / square;
}
#ifdef LAMPS
uniform vec3 lampPlace[LAMPS], lampLight[LAMPS];
// Of all lamps on a matt surface.
vec3 lampsOn(vec3 place, vec3 n) {
    vec3 all = vec3(0.0);
    for (int i = 0; i < LAMPS; ++i) {
        all += lampOn(lampLight[i], lampPlace[i] - place, n);
    }
    return all;
}
#else
vec3 lampsOn(vec3 place, vec3 n) { return vec3(0.0); }
#endif
#ifdef LEDS
uniform vec3 ledPlace[LEDS], ledLight[LEDS];
#ifdef LED_BEAMS
uniform vec4 ledBeam[LEDS]; // its axis, and how narrow it is; 0: it shines all around
#endif
vec3 ledsOn(vec3 place, vec3 n) {
    vec3 all = vec3(0.0);
    for (int i = 0; i < LEDS; ++i) {
        vec3 way = ledPlace[i] - place;
        vec3 light = ledLight[i];
#ifdef LED_BEAMS
        float ahead = -dot(ledBeam[i].xyz, way) * inversesqrt(max(dot(way, way), 1.0e-8));
        if (ledBeam[i].w > 0.0) light *= pow(max(ahead, 1.0e-4), ledBeam[i].w);
#endif
        all += lampOn(light, way, n);
    }
    return all;
}
#else
vec3 ledsOn(vec3 place, vec3 n) { return vec3(0.0); }
#endif
vec3 skyColour(vec3 d) { return mix(horizonColour, zenithColour, pow(clamp(d.z, 0.0, 1.0), 0.62)); }
