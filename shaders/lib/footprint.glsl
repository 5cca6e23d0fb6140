// The quad that covers the screen projection of a shadow volume. Needs volume.glsl and depth.glsl.

// Pixels from the middle of the picture to the projection of a place.
vec2 pixelOf(vec3 place) {
  vec4 clip = clipFromView * vec4(place, 1.0);
  return 0.5 * viewport * clip.xy / clip.w;
}

// One of the eight corners of the box around a volume.
vec3 boxCorner(int index, Ends ends) {
  vec2 at = vec2((index & 1) == 0 ? sides.x : sides.z, (index & 2) == 0 ? sides.y : sides.w);
  bool isStart = (index & 4) == 0;
  return (isStart ? ends.start : ends.end) + ends.sideAxes * at * (isStart ? ends.scales.x : ends.scales.y);
}

// Normalised device coordinates of a corner, whose components are -1 or 1, of the box around a volume, along its
// projection.
vec2 footprint(vec2 corner, Ends ends) {
  // Rasterisers move corners to a grid, at most as coarse as a sixteenth of a pixel.
  const float SNAP = 0.25;
  float front = clipFromView[2][3] == 0.0 ? 1e9 : -near;
  bool isInFront = ends.nearestZ < front;
  vec2 along = isInFront ? pixelOf(ends.end) - pixelOf(ends.start) : vec2(0.0);
  along = dot(along, along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  mat2 axes = mat2(along, vec2(-along.y, along.x));
  vec2 farthest = vec2(-1e9);
  // The edges, from both ends, without what is behind the near plane. If nothing is, their starts are enough.
  for (int i = 0; i < 24; i += isInFront ? 3 : 1) {
    vec3 place = boxCorner(i / 3, ends);
    if (!isInFront && place.z > front) {
      vec3 next = boxCorner(i / 3 ^ (1 << i % 3), ends);
      if (next.z >= front) continue;
      place = mix(place, next, (place.z - front) / (place.z - next.z));
    }
    farthest = max(farthest, corner * (pixelOf(place) * axes));
  }
  if (farthest.x == -1e9) return vec2(2.0);
  return axes * (corner * (farthest + SNAP)) / (0.5 * viewport);
}

// Clip space position of a corner at the depth of the point of a volume that is nearest to the eye.
vec4 cornerAt(vec2 ndc, Ends ends) {
  float nearestZ = min(ends.nearestZ, -near);
  // Clamped, because a rounding error at the near plane must not clip the quad.
  float minDepth = depthOrder(clipFromView) < 0.0 ? 0.0 : -1.0;
  return vec4(ndc, clamp(ndcDepth(clipFromView, nearestZ), minDepth, 1.0), 1.0);
}
