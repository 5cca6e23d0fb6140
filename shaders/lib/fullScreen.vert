// One triangle that covers the viewport, at the far end of the depth range.
in vec2 corner;

void main() {
  gl_Position = vec4(corner, 1.0, 1.0);
}
