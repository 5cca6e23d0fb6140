precision highp float;

uniform vec3 inkColor;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  unlit = vec4(inkColor, 1.0);
  lit = vec4(inkColor, 1.0);
}
