// The position of a point that covers a tile of the picture; outside the view if it is not drawn. A point whose centre is
// outside the picture would be clipped, so the last tiles of a row or column move inwards and overlap others. Sizes are in
// pixels.
vec4 tilePoint(ivec2 tile, float side, ivec2 picture, bool isDrawn) {
  vec2 size = vec2(picture);
  vec2 centre = min(side * (vec2(tile) + 0.5), max(size - 0.5 * side, 0.5 * size));
  return isDrawn ? vec4(2.0 * centre / size - 1.0, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
