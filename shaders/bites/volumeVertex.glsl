// Added to the vertex shaders with lib/volume.glsl.
#include place.glsl

// Places of the lobes along the light, where balls are balls.
flat out float middles[LOBES];

// Writes the outputs of bites. Returns the start of the volume: bites open the puff to the light up to its end.
// lengthwise: the direction whose dot product with a place is the place along the light where balls are balls; half of the length of a
// lobe along the light, in its radii.
float writeCut(float cap, mat3 discsFromPuff, vec4 lengthwise, vec3 travel, vec3 centre, mat2 sideAxes) {
  int variation = variationOf(attributes) % textureSize(casterTable, 0).y;
  float behind = 0.0;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    {
      vec4 lobe = lobeOf(UNROLLED_LOOP_INDEX, variation);
      vec3 seen = discsFromPuff * lobe.xyz;
      middles[ i ] = dot(lengthwise.xyz, seen);
      behind = max(behind, seen.z + lobe.w * lengthwise.w);
    }
  }
  #pragma unroll_loop_end
  mat2x3 bites = bitesIn(discsFromPuff);
  bites[0].z = dot(lengthwise.xyz, bites[0]);
  bites[1].z = dot(lengthwise.xyz, bites[1]);
#ifdef DEFORMED
  bites[0].y *= widthTiltFactor.z;
  bites[1].y *= widthTiltFactor.z;
  placeBites(bites, widthTiltFactor.x);
#else
  placeBites(bites, 1.0);
#endif
  return mix(cap, max(cap, startBehind(behind, travel, centre)), min(erosionOf(attributes) / BITE_STARTS.x, 1.0));
}
