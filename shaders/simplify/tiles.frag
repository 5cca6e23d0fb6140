precision highp float;
precision highp int;

// What the pixels of a tile of 8 x 8 have in common: one fragment for each. Output: their field, with 1/3 for a rim and
// 2/3 for smoke in alpha. Where pixels differ, the share of light is 1/2, which no pixel has.
out vec4 kind;

#include field.glsl
#include flatTiles.glsl

vec4 kindAt(ivec2 at) {
  Shading own = unpackShading(texelFetch(shading, at, 0));
  vec4 field = fieldOf(own, texelFetch(lit, at, 0).a);
  return vec4(field.rgb, (field.a + (own.radius > 0.0 ? 2.0 : 0.0)) / 3.0);
}

void main() {
  ivec2 start = FLAT_TILE * ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(lit, 0) - 1;
  kind = kindAt(start);
  for (int y = 0; y < FLAT_TILE; y++) {
    for (int x = 0; x < FLAT_TILE; x++) {
      if (kindAt(min(start + ivec2(x, y), last)) != kind) {
        kind = vec4(0.5);
        return;
      }
    }
  }
}
