const int FLAT_TILE = 8;

// Tiles on each side of a pixel's own that pixels within a distance can be in.
int tilesWithin(int pixels) {
  return (pixels + FLAT_TILE - 1) / FLAT_TILE;
}
