// Averages the fields of simplify/fields.frag along an axis, weighted by a Gaussian. It stops where pixels are not
// linked: at ink, at gaps in depth, and where smoke ends.
uniform sampler2D fields;
uniform sampler2D links;
// Largest distance that is averaged, pixels, and standard deviation of the Gaussian, pixels.
uniform int reach;
uniform float deviation;
// Of simplify/flat.frag.
uniform sampler2D flatTiles;

#include flatTiles.glsl

bool isLinkedAt(ivec2 at, int bit) {
  return (int(255.0 * texelFetch(links, at, 0).r + 0.5) & bit) != 0;
}

// `along` is (1, 0) with bit 1 or (0, 1) with bit 2.
vec4 smoothedAt(ivec2 at, ivec2 along, int bit) {
  vec4 sum = texelFetch(fields, at, 0);
  float weights = 1.0;
  // A loop that ends at once saves work on all GPUs; a branch does not.
  int end = texelFetch(flatTiles, at / FLAT_TILE, 0).r > 0.0 ? 0 : reach;
  // Ratio of neighbouring weights, and the ratio of neighbouring ratios.
  float first = exp(-0.5 / (deviation * deviation));
  float change = first * first;
  for (int way = 0; way < 2; way++) {
    float weight = 1.0;
    float ratio = first;
    for (int i = 1; i <= end; i++) {
      ivec2 there = way == 0 ? at + i * along : at - i * along;
      ivec2 link = way == 0 ? there - along : there;
      if (min(link.x, link.y) < 0 || !isLinkedAt(link, bit)) break;
      weight *= ratio;
      ratio *= change;
      sum += weight * texelFetch(fields, there, 0);
      weights += weight;
    }
  }
  return sum / weights;
}
