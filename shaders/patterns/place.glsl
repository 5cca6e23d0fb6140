// Where a pixel is on the surface of its puff, in four bytes; all zero where there is no smoke. FLAT_PLACE: beside the centre of
// the puff, across the view, in radii. Otherwise the direction from the centre, on an octahedron: Cigolle and others, 'A Survey
// of Efficient Representations for Independent Unit Vectors' (2014).

// Range of coordinates across the view, radii.
const float FLAT_RANGE = 8.0;

vec2 folded(vec2 point) {
  return (1.0 - abs(point.yx)) * vec2(point.x < 0.0 ? -1.0 : 1.0, point.y < 0.0 ? -1.0 : 1.0);
}

// @param place in view space, radii from the centre
vec4 packPlace(vec3 place) {
#ifdef FLAT_PLACE
  vec2 point = 2.0 * place.xy / FLAT_RANGE;
#else
  vec2 point = place.xy / max(abs(place.x) + abs(place.y) + abs(place.z), 1e-6);
  if (place.z < 0.0) point = folded(point);
#endif
  vec2 number = floor(32767.0 * (clamp(point, -1.0, 1.0) + 1.0) + 1.5);
  vec2 high = floor(number / 256.0);
  return vec4(high.x, number.x - 256.0 * high.x, high.y, number.y - 256.0 * high.y) / 255.0;
}

// The inverse: a place across the view in radii, or a unit vector in view space.
vec3 unpackPlace(vec4 code) {
  vec2 point = (vec2(dot(code.rg, vec2(65280.0, 255.0)), dot(code.ba, vec2(65280.0, 255.0))) - 1.0) / 32767.0 - 1.0;
#ifdef FLAT_PLACE
  return vec3(0.5 * FLAT_RANGE * point, 0.0);
#else
  float z = 1.0 - abs(point.x) - abs(point.y);
  return normalize(vec3(z < 0.0 ? folded(point) : point, z));
#endif
}
