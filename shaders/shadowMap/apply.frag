precision highp float;

// Adds the shadow to the alpha of the lit colour, the mask that the resolve pass reads. Screen space.
uniform sampler2D shadowed;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  unlit = vec4(0.0);
  lit = vec4(0.0, 0.0, 0.0, texelFetch(shadowed, ivec2(gl_FragCoord.xy), 0).r);
}
