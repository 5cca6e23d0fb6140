precision highp float;

// Marks the tiles of the picture that contain an edge: one fragment for each tile. A tile whose tones, with those of the
// pixels around it, span at most EDGE has none. Input: chosen tones of tones.frag. Output: 1 in red if the tile has an
// edge.
out vec4 mark;

#include ../lib/tones.glsl
// Side of a tile, pixels.
const int EDGE_TILE = 8;

void main() {
  ivec2 start = EDGE_TILE * ivec2(gl_FragCoord.xy) - 1;
  vec4 lowest = toneAt(start);
  vec4 highest = lowest;
  for (int y = 0; y < EDGE_TILE + 2; ++y) {
    for (int x = 0; x < EDGE_TILE + 2; ++x) {
      vec4 tone = toneAt(start + ivec2(x, y));
      lowest = min(lowest, tone);
      highest = max(highest, tone);
    }
  }
  mark = vec4(any(greaterThan(highest - lowest, vec4(EDGE))), 0.0, 0.0, 1.0);
}
