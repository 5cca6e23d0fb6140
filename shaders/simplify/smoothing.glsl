// Averages the fields of simplify/fields.frag along an axis, weighted by a Gaussian. It stops where pixels are not
// linked: at ink, at gaps in depth, and where smoke ends.
uniform sampler2D fields;
#ifdef ALONG_COLUMNS
// The averages along rows.
uniform sampler2D across;
#ifdef ADDITIONAL_LIGHTS
uniform sampler2D lightsAcross;
#endif
#endif
// Largest distance that is averaged, pixels, and standard deviation of the Gaussian, pixels.
uniform int reach;
uniform float deviation;
// Of simplify/flat.frag.
uniform sampler2D flatTiles;

#include flatTiles.glsl
#include packField.glsl

#ifdef ADDITIONAL_LIGHTS
// The averaged shares of the lights, besides the result of smoothedAt.
vec3 lightShares;

vec3 sharesAt(ivec2 at, PackedField there) {
#ifdef ALONG_COLUMNS
  return texelFetch(lightsAcross, at, 0).rgb;
#else
  return vec3(there.lights & 1, there.lights >> 1 & 1, there.lights >> 2);
#endif
}
#endif

PackedField fieldAt(ivec2 at) {
  PackedField here = unpackField(texelFetch(fields, at, 0));
#ifdef ALONG_COLUMNS
  here.field = texelFetch(across, at, 0);
#endif
  return here;
}

// `along` is (1, 0) with bit LINKED_RIGHT or (0, 1) with bit LINKED_ABOVE.
vec4 smoothedAt(ivec2 at, ivec2 along, int bit) {
  PackedField own = fieldAt(at);
  vec4 sum = own.field;
#ifdef ADDITIONAL_LIGHTS
  lightShares = sharesAt(at, own);
#endif
  float weights = 1.0;
  // A loop that ends at once saves work on all GPUs; a branch does not.
  int end = texelFetch(flatTiles, at / FLAT_TILE, 0).r > 0.0 ? 0 : reach;
  // Ratio of neighbouring weights, and the ratio of neighbouring ratios.
  float first = exp(-0.5 / (deviation * deviation));
  float change = first * first;
  for (int way = 0; way < 2; way++) {
    float weight = 1.0;
    float ratio = first;
    ivec2 towards = way == 0 ? along : -along;
    int before = own.links;
    // The last pixel of a row or column is not linked with one outside the picture; the first one has no such bit.
    int last = way == 0 ? end : min(end, at.x * along.x + at.y * along.y);
    for (int i = 1; i <= last; i++) {
      PackedField there = fieldAt(at + i * towards);
      if (((way == 0 ? before : there.links) & bit) == 0) break;
      before = there.links;
      weight *= ratio;
      ratio *= change;
      sum += weight * there.field;
#ifdef ADDITIONAL_LIGHTS
      lightShares += weight * sharesAt(at + i * towards, there);
#endif
      weights += weight;
    }
  }
#ifdef ADDITIONAL_LIGHTS
  lightShares /= weights;
#endif
  return sum / weights;
}
