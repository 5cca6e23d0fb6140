precision highp float;

// Rectangles over one half of the target, six vertices each. On the left, the second is behind the first, but its fragments
// write a smaller depth. On the right, it is in front and its fragments write a larger depth. An early depth test gives the
// wrong result in both halves.

// Whether the near plane has window depth 1 and clip space depth is 0 to 1.
uniform bool isReversed;

flat out float writtenDepth;
flat out float shown;

// Left side, depth of the polygon, depth that its fragments write, grey level.
const vec4 RECTANGLES[4] = vec4[4](
  vec4(-1.0, 0.25, 0.75, 0.5),
  vec4(0.0, 0.9, 0.25, 1.0),
  vec4(-1.0, 0.9, 0.5, 1.0),
  vec4(0.0, 0.1, 0.5, 0.5)
);

void main() {
  vec4 rectangle = RECTANGLES[gl_VertexID / 6];
  int vertex = gl_VertexID % 6;
  int corner = vertex < 3 ? vertex : 6 - vertex;
  float depth = isReversed ? 1.0 - rectangle.y : 2.0 * rectangle.y - 1.0;
  writtenDepth = isReversed ? 1.0 - rectangle.z : rectangle.z;
  shown = rectangle.w;
  gl_Position = vec4(rectangle.x + float(corner & 1), float((corner & 2) - 1), depth, 1.0);
}
