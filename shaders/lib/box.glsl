// How far a point travels along a unit direction before it has left a box grown by a margin; 0 if it never is inside.
float exitFromBox(vec3 point, vec3 direction, vec3 boxMin, vec3 boxMax, float margin) {
  const float PARALLEL = 1e-6;
  vec3 safe = mix(direction, vec3(PARALLEL), lessThan(abs(direction), vec3(PARALLEL)));
  vec3 exits = max((boxMin - margin - point) / safe, (boxMax + margin - point) / safe);
  return max(0.0, min(exits.x, min(exits.y, exits.z)));
}
