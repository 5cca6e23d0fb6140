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
  gl_Position = cornerAt(footprint(corner, ends), ends);
}
