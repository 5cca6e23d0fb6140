precision highp float;
precision highp int;

// A point over the tile of each arc that may have a stroke: few of them stand before other smoke.
flat out int arc;

#include arc.glsl
#include separation.glsl
#include placeTile.glsl

// A stroke covers more samples than lie between two of these, and stands before other smoke at more taps than are left out.
const int SAMPLE_STRIDE = 2;
const int TAP_STRIDE = 4;

bool isInPicture() {
  vec4 middle = clipFromView * vec4(centre + vec3(viewPoint(lobe.xy) * radius, 0.0), 1.0);
  float reach = lobe.w * radius;
#ifdef DEFORMED
  reach /= projection.factor;
#endif
  vec2 size = reach * vec2(clipFromView[0][0], clipFromView[1][1]);
  return all(lessThan(abs(middle.xy), middle.w + size));
}

bool isCandidate() {
  if (findArc() <= 0.0 || !isInPicture()) return false;
  for (int number = SAMPLE_STRIDE - 1; number <= LAST; number += SAMPLE_STRIDE) {
    if (separationAt(alongOf(number), TAP_STRIDE) > 0.0) return true;
  }
  return false;
}

void main() {
  arc = gl_VertexID;
  fetchArc(arc);
  placeTile(arc, isCandidate());
}
