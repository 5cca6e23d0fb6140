precision highp float;
precision highp int;

// Red is 1 for tiles whose pixels have the same field as all pixels that are averaged with them, so that no average is
// needed. Green is 1 for the others, and for tiles of smoke, whose tones this pass chooses.
uniform sampler2D tiles;
uniform int reach;

out vec4 tile;

#include flatTiles.glsl

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(tiles, 0) - 1;
  int beside = tilesWithin(reach);
  vec4 kind = texelFetch(tiles, at, 0);
  tile = vec4(0.0, 1.0, 0.0, 1.0);
  if (kind.r > 0.25 && kind.r < 0.75) return;
  for (int y = -beside; y <= beside; y++) {
    for (int x = -beside; x <= beside; x++) {
      vec4 other = texelFetch(tiles, clamp(at + ivec2(x, y), ivec2(0), last), 0);
      if (kind != ANY_LIGHT && other != ANY_LIGHT && other != kind) return;
    }
  }
  tile = vec4(1.0, kind.a > 0.5, 0.0, 1.0);
}
