precision highp float;
precision highp int;

// 1 for tiles whose pixels have the same field as all pixels that are averaged with them, so that no average is needed.
uniform sampler2D tiles;
uniform int reach;

out vec4 isFlat;

#include flatTiles.glsl

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(tiles, 0) - 1;
  int beside = (reach + FLAT_TILE - 1) / FLAT_TILE;
  vec4 field = texelFetch(tiles, at, 0);
  isFlat = vec4(0.0);
  if (field.r > 0.25 && field.r < 0.75) return;
  for (int y = -beside; y <= beside; y++) {
    for (int x = -beside; x <= beside; x++) {
      if (texelFetch(tiles, clamp(at + ivec2(x, y), ivec2(0), last), 0) != field) return;
    }
  }
  isFlat = vec4(1.0);
}
