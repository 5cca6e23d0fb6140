// The quad that covers the screen projection of a shadow volume. Needs volume.glsl.

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

// Pixels from the middle of the picture to the projection of a place.
vec2 pixelOf(vec3 place) {
  vec4 clip = clipFromView * vec4(place, 1.0);
  return 0.5 * viewport * clip.xy / clip.w;
}

// Normalised device coordinates of a corner, whose components are -1 or 1, of the box around a volume, along its
// projection. A volume that is partly behind the near plane has a box along the picture instead.
vec2 footprint(vec2 corner, Ends ends) {
  // Rasterisers move corners to a grid, at most as coarse as a sixteenth of a pixel.
  const float SNAP = 0.25;
  vec2 along = pixelOf(ends.end.xyz) - pixelOf(ends.start.xyz);
  along = dot(along, along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  mat2 axes = mat2(along, vec2(-along.y, along.x));
  vec2 farthest = vec2(-1e9);
  bool isInFront = true;
  for (int i = 0; i < 8; i++) {
    vec2 at = vec2((i & 1) == 0 ? sides.x : sides.z, (i & 2) == 0 ? sides.y : sides.w);
    vec4 end = (i & 4) == 0 ? ends.start : ends.end;
    vec3 place = end.xyz + ends.sideAxes * at * ((i & 4) == 0 ? ends.scales.x : ends.scales.y);
    isInFront = isInFront && clipFromView[2][3] * (place.z + near) >= 0.0;
    farthest = max(farthest, corner * (pixelOf(place) * axes));
  }
  if (isInFront) return axes * (corner * (farthest + SNAP)) / (0.5 * viewport);
  vec2 balls = vec2(ends.start.w, ends.end.w);
  vec2 x = slopesOf(vec2(ends.start.x, -ends.start.z), vec2(ends.end.x, -ends.end.z), balls);
  vec2 y = slopesOf(vec2(ends.start.y, -ends.start.z), vec2(ends.end.y, -ends.end.z), balls);
  vec2 point = mix(vec2(x.x, y.x), vec2(x.y, y.y), 0.5 + 0.5 * corner);
  // Clamped to the screen, because corners of open sides are imprecise farther out. An axis-aligned box stays a box.
  return clamp((clipFromView * vec4(point, -1.0, 0.0)).xy, -1.0, 1.0);
}
