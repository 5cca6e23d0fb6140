// Inserted into volumes/volumes.frag. 9: declarations.
float spreadAt(float height) {
  return 1.0 + eyeAndGrowth.w * height;
}

#include cut.glsl

// Whether a light ray meets what is left of a lobe.
bool isLeft(vec4 disc, vec2 point) {
  float halfExtent = spreadAt(disc.w) * sqrt(max(within(disc.xyz, point), 0.0));
  return halfExtent > 0.0 && topOf(disc.w, halfExtent) > disc.w - halfExtent;
}
#pragma section
  // 10: in the volume.
  meetBites(point);
  bool isShaded = false;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    isShaded = isShaded || isLeft(discs[ i ], point);
  }
  #pragma unroll_loop_end
  if (!isShaded) discard;
