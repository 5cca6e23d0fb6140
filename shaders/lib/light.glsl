// The unit vector from a place towards the light, both in one space. A light is (unit vector towards it, 0) where it is
// so far that all its rays are parallel, else (its place, 1).
vec3 towardsLightFrom(vec4 light, vec3 place) {
  return normalize(light.xyz - light.w * place);
}
