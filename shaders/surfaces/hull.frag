precision highp float;

// The flat colour of a line of a surface, which is a hull or a crease. An alpha of 1 in the lit colour marks ink, which
// shadows do not darken.
uniform vec3 inkColor;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  unlit = vec4(inkColor, 1.0);
  lit = vec4(inkColor, 1.0);
}
