// Inserted into lib/volume.glsl. 7: declarations.
#include place.glsl

// Places of the lobes along the light, where balls are balls.
flat out float middles[LOBES];
#pragma section
  // 8: after the start. Bites open the puff to the light up to its end.
  mat3 discsFromPuff = frameFromView * viewFromPuff;
  vec3 depthRow = vec3(0.0, 0.0, 1.0);
  float halfOfLobe = 1.0;
#ifdef DEFORMED
  halfOfLobe = width * sqrt(support);
  // Where balls are balls along the light, too.
  depthRow = projection.depth * vec3(0.0, dot(projection.shear, along), 1.0);
#endif
  int variation = variationOf(attributes) % textureSize(casterTable, 0).y;
  float behind = 0.0;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    {
      vec4 lobe = lobeOf(UNROLLED_LOOP_INDEX, variation);
      vec3 seen = discsFromPuff * lobe.xyz;
      middles[ i ] = dot(depthRow, seen);
      behind = max(behind, seen.z + lobe.w * halfOfLobe);
    }
  }
  #pragma unroll_loop_end
  cap = mix(cap, max(cap, startBehind(behind, axis, centre)), min(erosionOf(attributes) / BITE_STARTS.x, 1.0));
  vec3 first = discsFromPuff * FIRST_BITE;
  vec3 third = discsFromPuff * THIRD_BITE;
  first.z = dot(depthRow, first);
  third.z = dot(depthRow, third);
#ifdef DEFORMED
  first.y *= widthTiltFactor.z;
  third.y *= widthTiltFactor.z;
#endif
  placeBites(first, third, width);
