precision highp float;
precision highp int;
precision highp sampler2DArray;

// A shadow volume of lib/volume.glsl: a quad covers its projection, at the depth of its nearest point.
uniform vec2 viewport;

#include ../lib/rows.glsl
#include ../lib/volume.glsl
#include ../lib/depth.glsl
#include ../lib/footprint.glsl

void main() {
  readRow();
  Ends ends;
  if (!writeVolume(ends)) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec2 ndc = footprint(corner, ends);
  float nearestZ = min(ends.nearestZ, -near);
  // Clamped, because a rounding error at the near plane must not clip the quad.
  float minDepth = depthOrder(clipFromView) < 0.0 ? 0.0 : -1.0;
  gl_Position = vec4(ndc, clamp(ndcDepth(clipFromView, nearestZ), minDepth, 1.0), 1.0);
}
