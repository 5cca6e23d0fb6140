// Added to bodies/lobes.vert.
#include place.glsl

bool isEaten(vec4 lobe, vec3 bite, float radius) {
  return distance(lobe.xyz, bite) + lobe.w < radius;
}

// Writes the outputs of bites, and the box around what is left.
void cutLobes(mat2x3 bites, out vec2 lowest, out vec2 highest) {
  vec3 radii = placeBites(bites, 1.0);
  lowest = highest = vec2(0.0);
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    // Nothing must be drawn around a lobe of which nothing is left. It moves farther away than any line is wide.
    if (isEaten(lobes[ i ], nearBite, radii.x) || isEaten(lobes[ i ], -nearBite, radii.y) || isEaten(lobes[ i ], sideBite, radii.z)) {
      lobes[ i ] = vec4(1e4, 0.0, 0.0, 0.0);
    } else {
      lowest = min(lowest, lobes[ i ].xy - lobes[ i ].w);
      highest = max(highest, lobes[ i ].xy + lobes[ i ].w);
    }
  }
  #pragma unroll_loop_end
}
