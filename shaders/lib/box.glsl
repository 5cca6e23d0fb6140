// Distance along a unit direction at which a point, and a disc about it, has left a box; 0 if it never is inside. The
// radius of the disc is `margin` at the point and increases by `growth` per unit of distance.
float exitFromBox(vec3 point, vec3 direction, vec3 boxMin, vec3 boxMax, float margin, float growth) {
  const float PARALLEL = 1e-6;
  vec3 way = mix(point - boxMin, boxMax - point, greaterThan(direction, vec3(0.0))) + margin;
  vec3 exits = way / max(abs(direction) - growth, PARALLEL);
  return max(0.0, min(exits.x, min(exits.y, exits.z)));
}

// Distance from a point to the farthest corner of a box.
float farthestCorner(vec3 place, vec3 boxMin, vec3 boxMax) {
  return length(max(abs(place - boxMin), abs(place - boxMax)));
}
