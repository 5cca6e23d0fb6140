const int FLAT_TILE = 8;
