precision highp float;

// An ordinary mesh, shaded by its own two rows of the ramps.
uniform sampler2D ramps;
uniform float litRow;
uniform float unlitRow;
uniform vec3 towardsLight;

in vec3 worldNormal;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

#include ../lib/shade.glsl

void main() {
  Shades shades = shade(normalize(worldNormal), towardsLight, ramps, vec2(unlitRow, litRow), vec3(1.0));
  unlit = vec4(shades.unlit, 1.0);
  lit = vec4(shades.lit, 0.0);
}
