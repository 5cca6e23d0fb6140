const int FLAT_TILE = 8;

// Number of tiles on each side of a tile that a distance reaches.
int tilesWithin(int pixels) {
  return (pixels + FLAT_TILE - 1) / FLAT_TILE;
}

// The field of tiles that look the same in light and shadow. No pixel has it.
const vec4 ANY_LIGHT = vec4(0.0, 1.0, 0.0, 0.0);
