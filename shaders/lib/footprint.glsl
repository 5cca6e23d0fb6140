// The quad that covers the screen projection of the convex hull of two spheres, for the polygons of a shadow volume.

// Radius, on the plane at unit depth, of a circle around the projected centre that covers the projected sphere;
// negative if the sphere extends behind the camera or too far to its side.
float projectedRadius(vec3 centre, float ball, float near) {
  float squared = dot(centre, centre) - ball * ball;
  if (squared <= 0.0 || -centre.z <= near + ball) return -1.0;
  float slope = length(centre.xy) / -centre.z;
  float widening = ball * inversesqrt(squared);
  float remaining = 1.0 - slope * widening;
  return remaining > 0.1 ? (slope + widening) / remaining - slope : -1.0;
}

// The range of directions that two spheres and their hull span, as slopes against the view axis in one plane through
// it. Points are (sideways, forward). Spheres beside or behind the camera leave a side open; the range is empty if
// nothing is in front.
vec2 slopesOf(vec2 from, vec2 to, vec2 balls) {
  const float OPEN = 1e4;
  const float PI = 3.14159265359;
  const float ASIDE = 1.57;
  vec2 reach = vec2(length(from), length(to));
  if (any(lessThanEqual(reach, balls))) return vec2(-OPEN, OPEN);
  float start = atan(from.x, from.y);
  float angle = atan(to.x, to.y) - start;
  float end = start + angle - 2.0 * PI * round(angle / (2.0 * PI));
  vec2 widening = asin(balls / reach);
  vec2 span = vec2(min(start - widening.x, end - widening.y), max(start + widening.x, end + widening.y));
  if (span.y - span.x >= PI) return vec2(-OPEN, OPEN);
  // The same range, expressed half a turn the other way, can be in front of the camera.
  if (span.x > ASIDE) span -= 2.0 * PI;
  if (span.y < -ASIDE) span += 2.0 * PI;
  if (span.x > ASIDE || span.y < -ASIDE) return vec2(0.0);
  return vec2(span.x <= -ASIDE ? -OPEN : tan(span.x), span.y >= ASIDE ? OPEN : tan(span.y));
}

// Corner of the oriented box around the projections of two spheres, on the plane at unit depth.
vec2 boxCorner(vec2 corner, vec2 from, vec2 to, float span) {
  vec2 along = to - from;
  float reach = length(along);
  along = reach > 1e-6 ? along / reach : vec2(1.0, 0.0);
  return 0.5 * (from + to) + along * corner.x * (0.5 * reach + span) + vec2(-along.y, along.x) * corner.y * span;
}

// Normalised device coordinates of a corner, whose components are -1 or 1. Each sphere is its centre in view space and
// its radius.
vec2 footprint(vec2 corner, vec4 start, vec4 end, mat4 clipFromView, float near) {
  bool perspective = clipFromView[2][3] != 0.0;
  if (!perspective) return (clipFromView * vec4(boxCorner(corner, start.xy, end.xy, max(start.w, end.w)), 0.0, 1.0)).xy;
  vec2 spans = vec2(projectedRadius(start.xyz, start.w, near), projectedRadius(end.xyz, end.w, near));
  if (min(spans.x, spans.y) >= 0.0) {
    vec2 point = boxCorner(corner, start.xy / -start.z, end.xy / -end.z, max(spans.x, spans.y));
    return (clipFromView * vec4(point, -1.0, 0.0)).xy;
  }
  vec2 balls = vec2(start.w, end.w);
  vec2 x = slopesOf(vec2(start.x, -start.z), vec2(end.x, -end.z), balls);
  vec2 y = slopesOf(vec2(start.y, -start.z), vec2(end.y, -end.z), balls);
  vec2 point = mix(vec2(x.x, y.x), vec2(x.y, y.y), 0.5 + 0.5 * corner);
  // Clamped to the screen, because corners of open sides are imprecise farther out. An axis-aligned box stays a box.
  return clamp((clipFromView * vec4(point, -1.0, 0.0)).xy, -1.0, 1.0);
}
