precision highp float;
precision highp int;

// Covers each tile that contains an edge with one point, so that the shader of edges runs nowhere else: some GPUs run a
// fragment shader before they test depth and stencil. A point whose centre is outside the picture would be clipped, so
// the last tiles of a row or column move inwards and overlap others.
uniform sampler2D tones;
// Marks of tiles.frag.
uniform sampler2D tiles;

// Side of a tile, pixels.
const int EDGE_TILE = 8;

void main() {
  ivec2 count = textureSize(tiles, 0);
  ivec2 tile = ivec2(gl_VertexID % count.x, gl_VertexID / count.x);
  bool hasEdge = texelFetch(tiles, tile, 0).r > 0.5;
  vec2 size = vec2(textureSize(tones, 0));
  float side = float(EDGE_TILE);
  vec2 centre = min(side * (vec2(tile) + 0.5), max(size - 0.5 * side, 0.5 * size));
  gl_Position = hasEdge ? vec4(2.0 * centre / size - 1.0, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
  gl_PointSize = side;
}
