// Ellipsoids seen along an axis. A parallel projection of a stretched puff is that of an unstretched one, in another
// orientation, with the picture compressed in one direction and sheared in depth: the lobes are balls there.

// Width of a stretched puff across the stretch, by the ratio of its axes. Seen across it, a lobe keeps its area.
float acrossOf(float ratio) {
  return inversesqrt(ratio);
}

// How a puff appears along z, in units of its width across the stretch.
struct Projection {
  // Unit vector of the image plane along which the picture is longer.
  vec2 along;
  // Factor on coordinates in this direction that makes ellipses circles: from 1 / ratio to 1.
  float factor;
  // Factor on depths, after the shear.
  float depth;
  vec2 shear;
};

// stretch: axis, a unit vector, and ratio.
Projection projectionOf(vec4 stretch) {
  float excess = 1.0 / (stretch.w * stretch.w) - 1.0;
  float squared = 1.0 + excess * stretch.z * stretch.z;
  float beside = length(stretch.xy);
  vec2 along = beside > 1e-5 ? stretch.xy / beside : vec2(1.0, 0.0);
  return Projection(along, inversesqrt(squared) / stretch.w, sqrt(squared), excess * stretch.z / squared * stretch.xy);
}

vec2 scaled(Projection projection, vec2 point, float factor) {
  return point + (factor - 1.0) * dot(projection.along, point) * projection.along;
}

// The place of a point where the lobes are balls.
vec3 unstretched(Projection projection, vec3 point) {
  return vec3(
    scaled(projection, point.xy, projection.factor),
    projection.depth * (point.z + dot(projection.shear, point.xy))
  );
}

// The normal of a surface, by the normal where the lobes are balls. Not a unit vector.
vec3 stretchedNormal(Projection projection, vec3 normal) {
  float depth = projection.depth * normal.z;
  return vec3(scaled(projection, normal.xy, projection.factor) + depth * projection.shear, depth);
}
