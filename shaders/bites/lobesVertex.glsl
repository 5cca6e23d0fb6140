// Inserted into bodies/lobes.vert. 0: declarations.
#include place.glsl
#include pair.glsl

// The bite of the first two that is nearer to the eye, where lobes are balls. The other one is opposite to it.
flat out vec4 nearBite;
// Its radius is paired with that of the far bite.
flat out vec4 sideBiteAndPair;

// Farther away from the puff than any line is wide, in radii.
const float GONE = 1e4;

bool isEaten(vec4 lobe, vec3 bite, float radius) {
  return distance(lobe.xyz, bite) + lobe.w < radius;
}
#pragma section
  // 1: after the lobes.
  vec3 first = viewFromPuff * firstBite(variation);
  vec3 third = viewFromPuff * sideBite(variation);
#ifdef DEFORMED
  first = unstretched(projection, first / across);
  third = unstretched(projection, third / across);
#endif
  vec3 radii = biteRadii(erosionOf(attributes));
  if (first.z < 0.0) {
    first = -first;
    radii.xy = radii.yx;
  }
  nearBite = vec4(first, radii.x);
  sideBiteAndPair = vec4(third, pairOf(radii.yz));
  lowest = vec2(0.0);
  highest = vec2(0.0);
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    // Nothing must be drawn around a lobe of which nothing is left.
    if (isEaten(lobes[ i ], first, radii.x) || isEaten(lobes[ i ], -first, radii.y) || isEaten(lobes[ i ], third, radii.z)) {
      lobes[ i ] = vec4(GONE, GONE, 0.0, 0.0);
    } else {
      lowest = min(lowest, lobes[ i ].xy - lobes[ i ].w);
      highest = max(highest, lobes[ i ].xy + lobes[ i ].w);
    }
  }
  #pragma unroll_loop_end
