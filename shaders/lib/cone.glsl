// The stretch (enter, leave) of the ray origin + t * ray inside a cone that is cut flat at both ends: from `start` along
// the unit `axis` for `extent`, with a radius there that grows by `growth` for each unit; a cylinder where that is 0.
// Empty where enter >= leave.
vec2 rayInCone(vec3 origin, vec3 ray, vec3 start, vec3 axis, float extent, float radius, float growth) {
  const vec2 MISS = vec2(1.0, 0.0);
  const float BOUNDLESS = 1e20;
  vec3 offset = origin - start;
  float offsetAlong = dot(offset, axis);
  float rayAlong = dot(ray, axis);
  vec3 offsetAcross = offset - offsetAlong * axis;
  vec3 rayAcross = ray - rayAlong * axis;
  float reach = radius + growth * offsetAlong;
  float spread = growth * rayAlong;
  float a = dot(rayAcross, rayAcross) - spread * spread;
  float b = dot(offsetAcross, rayAcross) - reach * spread;
  float c = dot(offsetAcross, offsetAcross) - reach * reach;
  vec2 side = vec2(-BOUNDLESS, BOUNDLESS);
  if (abs(a) > 1e-9) {
    float discriminant = b * b - a * c;
    if (discriminant <= 0.0) return MISS;
    float halfChord = sqrt(discriminant);
    side = vec2(-b - halfChord, -b + halfChord) / a;
    // Steeper than the sides: the ray enters once and stays, on the half of the double cone that opens away from the light.
    if (a < 0.0) side = spread > 0.0 ? vec2(side.x, BOUNDLESS) : vec2(-BOUNDLESS, side.y);
  } else if (c > 0.0) {
    return MISS;
  }
  vec2 caps = vec2(-BOUNDLESS, BOUNDLESS);
  if (abs(rayAlong) > 1e-9) {
    vec2 hits = vec2(-offsetAlong, extent - offsetAlong) / rayAlong;
    caps = vec2(min(hits.x, hits.y), max(hits.x, hits.y));
  } else if (offsetAlong < 0.0 || offsetAlong > extent) {
    return MISS;
  }
  return vec2(max(side.x, caps.x), min(side.y, caps.y));
}
