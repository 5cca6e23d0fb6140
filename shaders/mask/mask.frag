precision highp float;

// Adds to the alpha of the lit colour where the stencil test passes: the mask that the resolve pass reads. Screen
// space.
uniform float share;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  unlit = vec4(0.0);
  lit = vec4(0.0, 0.0, 0.0, share);
}
