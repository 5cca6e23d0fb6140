precision highp float;
precision highp int;

// The first half of the smoothing, along rows. Output: the averaged fields.
out vec4 field;

#include smoothing.glsl

void main() {
  field = smoothedAt(ivec2(gl_FragCoord.xy), ivec2(1, 0), LINKED_RIGHT);
}
