#include ../lib/shading.glsl

// The radius is 0 where there is no smoke.
Shading unpackShading(vec4 texel) {
  vec3 bytes = floor(255.0 * texel.gba + 0.5);
  float high = floor(bytes.y / MATERIALS_HIGH);
  int flags = int(bytes.y - MATERIALS_HIGH * high);
  float radius = bytes.z > 0.0 ? exp2(mix(LOG_RADII.x, LOG_RADII.y, bytes.z / 255.0)) : 0.0;
  return Shading(texel.r, bytes.x + 256.0 * high, (flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0, radius);
}
