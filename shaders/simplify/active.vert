precision highp float;
precision highp int;

// Covers with one point each tile whose tones depend on averages or on smoke, and with NEARBY also those whose pixels are
// averaged with it. The others keep the plain tones.
uniform sampler2D lit;
// Of simplify/flat.frag.
uniform sampler2D flatTiles;
uniform int reach;

#include ../lib/tilePoint.glsl
#include flatTiles.glsl

bool isActive(ivec2 tile) {
  if (texelFetch(flatTiles, tile, 0).g > 0.5) return true;
#ifdef NEARBY
  ivec2 last = textureSize(flatTiles, 0) - 1;
  int beside = tilesWithin(reach);
  for (int y = -beside; y <= beside; y++) {
    for (int x = -beside; x <= beside; x++) {
      if (texelFetch(flatTiles, clamp(tile + ivec2(x, y), ivec2(0), last), 0).r < 0.5) return true;
    }
  }
#endif
  return false;
}

void main() {
  ivec2 count = textureSize(flatTiles, 0);
  ivec2 tile = ivec2(gl_VertexID % count.x, gl_VertexID / count.x);
  gl_Position = tilePoint(tile, float(FLAT_TILE), textureSize(lit, 0), isActive(tile));
  gl_PointSize = float(FLAT_TILE);
}
