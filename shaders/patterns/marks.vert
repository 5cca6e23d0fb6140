precision highp float;
precision highp int;

// Covers with one point each tile that marks can reach. ON_SMOKE, ON_SURFACES or ON_BACKDROP: what they are on.
uniform sampler2D amounts;
// Marks of tiles.frag.
uniform sampler2D tiles;
// Distance from its pixel at which a mark can be drawn, in tiles.
uniform ivec2 lowestTile;
uniform ivec2 highestTile;

#include ../lib/tilePoint.glsl

// Side of a tile, pixels.
const int EDGE_TILE = 8;
// Component of tiles.frag.
#if defined(ON_SMOKE)
const int ON = 0;
#elif defined(ON_SURFACES)
const int ON = 1;
#else
const int ON = 2;
#endif

void main() {
  ivec2 count = textureSize(tiles, 0);
  ivec2 tile = ivec2(gl_VertexID % count.x, gl_VertexID / count.x);
  bool isReached = false;
  for (int y = lowestTile.y; y <= highestTile.y; ++y) {
    for (int x = lowestTile.x; x <= highestTile.x; ++x) {
      isReached = isReached || texelFetch(tiles, clamp(tile + ivec2(x, y), ivec2(0), count - 1), 0)[ON] > 0.5;
    }
  }
  gl_Position = tilePoint(tile, float(EDGE_TILE), textureSize(amounts, 0), isReached);
  gl_PointSize = float(EDGE_TILE);
}
