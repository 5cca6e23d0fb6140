// Support of the silhouettes of billboards: how far they extend in directions that are evenly spaced, from the x axis on. One row
// for each layer, in radii.
uniform highp sampler2D supports;

float supportAt(int direction, int layer) {
  return texelFetch(supports, ivec2(direction % textureSize(supports, 0).x, layer), 0).r;
}

// An upper bound of the extent in any direction, a vector of length 1: supports are sublinear.
float supportOf(vec2 direction, int layer) {
  float apart = 6.28318530718 / float(textureSize(supports, 0).x);
  float angle = atan(direction.y, direction.x) + 6.28318530718;
  int first = int(angle / apart);
  float rest = angle - float(first) * apart;
  return (sin(apart - rest) * supportAt(first, layer) + sin(rest) * supportAt(first + 1, layer)) / sin(apart);
}
