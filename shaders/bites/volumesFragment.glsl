// Added to volumes/volumes.frag.
float spreadAt(float height) {
  return 1.0 + eyeAndGrowth.w * height;
}

#include cut.glsl

flat in float middles[LOBES];

// Whether a light ray meets what is left of a lobe.
bool isLeftOf(vec3 disc, float middle, vec2 point) {
  float halfExtent = spreadAt(middle) * sqrt(max(within(disc, point), 0.0));
  return halfExtent > 0.0 && topOf(middle, halfExtent) > middle - halfExtent;
}

// Whether a light ray meets what is left of the puff.
bool isLeft(vec2 point) {
  meetBites(point);
  bool isShaded = false;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    isShaded = isShaded || isLeftOf(discs[ i ], middles[ i ], point);
  }
  #pragma unroll_loop_end
  return isShaded;
}
