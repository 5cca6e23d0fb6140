#ifndef REACH
#define REACH
// Share of the light of a lamp that reaches a place, as `punctualLightIntensity` of three.js computes it.
// @param way from the place to the lamp
// @param reach exponent, 1 / distance of the end, least distance raised to the exponent, and a factor
// @param cone the dot product of xyz and the direction to the lamp, plus w, goes from 0 to 1 from the edge of the cone inwards
float reachOf(vec3 way, vec4 reach, vec4 cone) {
  float squared = max(dot(way, way), 1e-12);
  float distance = sqrt(squared);
  float ends = squared * reach.y * reach.y;
  float atEnd = clamp(1.0 - ends * ends, 0.0, 1.0);
  float decayed = reach.x == 2.0 ? squared : pow(distance, reach.x);
  float inside = clamp(dot(cone.xyz, way) / distance + cone.w, 0.0, 1.0);
  return reach.w * inside * inside * (3.0 - 2.0 * inside) * atEnd * atEnd / max(decayed, reach.z);
}
#endif
