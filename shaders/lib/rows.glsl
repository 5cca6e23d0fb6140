// The row and the corner of a vertex. Call readRow or fetchRow first.
#include fetchRow.glsl
uniform int rowVertices;

// Corner of the quad, components -1 or 1.
vec2 corner;

void findCorner() {
  int number = gl_VertexID % 4;
  corner = vec2(number == 1 || number == 2 ? 1.0 : -1.0, number < 2 ? -1.0 : 1.0);
}

// Reads a row by vertex number.
void readRow() {
  fetchRow(gl_VertexID / rowVertices);
  findCorner();
}
