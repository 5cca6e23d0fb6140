precision highp float;
precision highp int;

// Covers each tile that contains an edge with one point, so that the shader of edges runs nowhere else: some GPUs run a
// fragment shader before they test depth and stencil.
uniform sampler2D tones;
// Marks of tiles.frag.
uniform sampler2D tiles;

#include ../lib/tilePoint.glsl

// Side of a tile, pixels.
const int EDGE_TILE = 8;

void main() {
  ivec2 count = textureSize(tiles, 0);
  ivec2 tile = ivec2(gl_VertexID % count.x, gl_VertexID / count.x);
  bool hasEdge = texelFetch(tiles, tile, 0).r > 0.5;
  gl_Position = tilePoint(tile, float(EDGE_TILE), textureSize(tones, 0), hasEdge);
  gl_PointSize = float(EDGE_TILE);
}
