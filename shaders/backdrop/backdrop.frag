precision highp float;

// Paints what lies behind everything: a vertical blend of two display-encoded colours, opaque.
// Nothing darkens it, so lit and unlit are the same.
uniform vec3 topColor;
uniform vec3 bottomColor;
uniform vec2 viewport;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  vec3 color = mix(bottomColor, topColor, gl_FragCoord.y / viewport.y);
  unlit = vec4(color, 1.0);
  lit = vec4(color, 0.0);
}
