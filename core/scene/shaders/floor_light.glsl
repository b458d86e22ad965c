// Light on a floor in the rich look.
uniform vec3 floorLight, floorNormal;
#if defined(SUN_MAP) || defined(SKY_MAP)
#define LIGHT_VARIES
vec3 floorLightAt(vec3 place) {
    vec3 ambient = mix(groundLight, skyLight, 0.5 + 0.5 * floorNormal.z), sun = sunLight * max(dot(floorNormal, sunWay), 0.0);
#ifdef SKY_MAP
    ambient *= skySeen(place);
#endif
#ifdef SUN_MAP
    sun *= sunSeen(place, floorNormal);
#endif
    return ambient + sun + lampsOn(place, floorNormal) + ledsOn(place, floorNormal);
}
#endif
