// The stretch (enter, leave) of the ray origin + t * ray inside a finite cylinder with flat ends:
// from `start` along the unit `axis` for `extent`, with a radius. Empty where enter >= leave.
vec2 rayInCylinder(vec3 origin, vec3 ray, vec3 start, vec3 axis, float extent, float radius) {
  const vec2 MISS = vec2(1.0, 0.0);
  const float BOUNDLESS = 1e20;
  vec3 offset = origin - start;
  float offsetAlong = dot(offset, axis);
  float rayAlong = dot(ray, axis);
  vec3 offsetAcross = offset - offsetAlong * axis;
  vec3 rayAcross = ray - rayAlong * axis;
  float a = dot(rayAcross, rayAcross);
  float b = dot(offsetAcross, rayAcross);
  float c = dot(offsetAcross, offsetAcross) - radius * radius;
  vec2 side = vec2(-BOUNDLESS, BOUNDLESS);
  if (a > 1e-12) {
    float discriminant = b * b - a * c;
    if (discriminant <= 0.0) return MISS;
    float halfChord = sqrt(discriminant);
    side = vec2(-b - halfChord, -b + halfChord) / a;
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
