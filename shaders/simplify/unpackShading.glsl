#include ../lib/shading.glsl

// The radius is 0 where there is no smoke.
Shading unpackShading(vec4 texel) {
  vec2 bytes = floor(255.0 * texel.gb + 0.5);
  float high = floor(bytes.y / MATERIALS_HIGH);
  int flags = int(bytes.y - MATERIALS_HIGH * high);
  return Shading(texel.r, bytes.x + 256.0 * high, (flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0, radiusOf(texel.a));
}
