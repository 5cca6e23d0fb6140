precision highp float;

// Where the stencil holds a count, adds one to the alpha of the lit colour: the mask that resolve reads.
layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  unlit = vec4(0.0);
  lit = vec4(0.0, 0.0, 0.0, 1.0);
}
