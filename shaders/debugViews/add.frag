precision highp float;

// Adds a number, as 255ths, to the red of the unlit colour.
uniform float number;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  unlit = vec4(number / 255.0, 0.0, 0.0, 0.0);
  lit = vec4(0.0);
}
