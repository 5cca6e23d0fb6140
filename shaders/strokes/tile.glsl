// Arcs have square tiles in the targets of samples, in reading order. A texel of a tile is a sample of the arc; of the others,
// one is the opacity of the arc, one is REACH_OF_ARC as a share of the reach of averages, and the last one says whether the arc
// has samples. TILE: side of a tile, texels.
uniform ivec2 tilesSize;

const int LAST = 20;
const int OPACITY_TEXEL = LAST + 1;
const int REACH_TEXEL = LAST + 2;
const int LAST_TEXEL = TILE * TILE - 1;
// Reach of the average about the middle of a stroke, at least in CSS pixels and as a share of its arc.
const float REACH = 40.0;
const float REACH_OF_ARC = 0.35;

ivec2 tileOf(int arc) {
  int perLine = tilesSize.x / TILE;
  return TILE * ivec2(arc % perLine, arc / perLine);
}

ivec2 texelOf(int arc, int number) {
  return tileOf(arc) + ivec2(number % TILE, number / TILE);
}

// The sample of a fragment.
int numberOf(int arc, vec2 pixel) {
  ivec2 texel = ivec2(pixel) - tileOf(arc);
  return texel.x + TILE * texel.y;
}

float alongOf(int number) {
  return 2.0 * float(number) / float(LAST) - 1.0;
}
