// Places a point over a tile, or nowhere. Needs tile.glsl.
void placeTile(int arc, bool isDrawn) {
  vec2 middle = vec2(tileOf(arc)) + 0.5 * float(TILE);
  gl_Position = isDrawn ? vec4(2.0 * middle / vec2(tilesSize) - 1.0, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
  gl_PointSize = float(TILE);
}
