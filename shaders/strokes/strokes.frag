precision highp float;
precision highp int;

// The opacity of a stroke where no smoke is before its lobe.
uniform mat4 clipFromView;

in vec2 beside;
in float outlineZ;
flat in float bulge;
in float opacity;

out vec4 coverage;

#include ../lib/depth.glsl
#include ../lib/smokeDepth.glsl

// Height of smoke before the lobe, in its radii, that hides a stroke.
const float COVER = 0.04;

void main() {
  float z = smokeZ(clipFromView, gl_FragCoord.xy);
  float top = outlineZ + bulge * (sqrt(max(0.0, 1.0 - dot(beside, beside))) + COVER);
  if (z < NO_SMOKE || z > top) discard;
  coverage = vec4(opacity);
}
