precision highp float;

// The background: an opaque vertical gradient of two display-encoded colours, in screen space. Shadows do not darken
// it, so lit and unlit are equal.
uniform vec3 topColor;
uniform vec3 bottomColor;
uniform vec2 viewport;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;
// Number of the group of a surface, see shaders/surfaces/surfaces.frag.
layout(location = 2) out float number;

void main() {
  vec3 color = mix(bottomColor, topColor, gl_FragCoord.y / viewport.y);
  unlit = vec4(color, 1.0);
  lit = vec4(color, 0.0);
  number = 0.0;
}
