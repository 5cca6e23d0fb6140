precision highp float;

// Marks the tiles of the picture that contain an edge: one fragment for each tile. Input: chosen tones of tones.frag.
// Output: 1 in red if a pixel of the tile differs by more than EDGE from one of its eight neighbours. Gradients span
// more than that over a tile of a small picture, but have no edges.
out vec4 mark;

#include ../lib/tones.glsl
// Side of a tile, pixels.
const int EDGE_TILE = 8;

// The largest difference between neighbours.
vec4 widestGap(ivec2 start) {
  vec4 widest = vec4(0.0);
  for (int y = 1; y < EDGE_TILE + 2; ++y) {
    vec4 west = toneAt(start + ivec2(0, y));
    vec4 southWest = toneAt(start + ivec2(0, y - 1));
    widest = max(widest, abs(west - southWest));
    for (int x = 1; x < EDGE_TILE + 2; ++x) {
      vec4 own = toneAt(start + ivec2(x, y));
      vec4 south = toneAt(start + ivec2(x, y - 1));
      widest = max(widest, max(max(abs(own - west), abs(own - south)), max(abs(own - southWest), abs(west - south))));
      west = own;
      southWest = south;
    }
  }
  return widest;
}

// The difference between the lowest and the highest tone.
vec4 spanOf(ivec2 start) {
  vec4 lowest = toneAt(start);
  vec4 highest = lowest;
  for (int y = 0; y < EDGE_TILE + 2; ++y) {
    for (int x = 0; x < EDGE_TILE + 2; ++x) {
      vec4 tone = toneAt(start + ivec2(x, y));
      lowest = min(lowest, tone);
      highest = max(highest, tone);
    }
  }
  return highest - lowest;
}

void main() {
  ivec2 start = EDGE_TILE * ivec2(gl_FragCoord.xy) - 1;
  bool hasEdge = any(greaterThan(spanOf(start), vec4(EDGE))) && any(greaterThan(widestGap(start), vec4(EDGE)));
  mark = vec4(hasEdge, 0.0, 0.0, 1.0);
}
