precision highp float;

// Adds a number, in units of 1/255, to the red channel of the unlit colour.
uniform float number;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  unlit = vec4(number / 255.0, 0.0, 0.0, 0.0);
  lit = vec4(0.0);
}
