// Side of a tile of simplify/tiles.frag, pixels.
const int FLAT_TILE = 8;
