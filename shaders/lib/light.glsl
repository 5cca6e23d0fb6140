// The unit vector from a point towards the light, both in the same space. A light is (unit vector towards it, 0) if it
// is directional, else (position, 1).
vec3 towardsLightFrom(vec4 light, vec3 place) {
  return normalize(light.xyz - light.w * place);
}
