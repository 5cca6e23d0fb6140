// Rows of the simulator: src/device/drawnRows.ts. Call readRow or fetchRow first.
uniform highp sampler2D rowPlaces;
// Two rows in a texel.
uniform highp usampler2D rowAttributes;
uniform int rowVertices;

// World position and radius.
vec4 place;
// See attributes.glsl.
uvec2 attributes;
// Corner of the quad, components -1 or 1.
vec2 corner;

void fetchRow(int row) {
  int perLine = textureSize(rowPlaces, 0).x;
  ivec2 texel = ivec2(row % perLine, row / perLine);
  place = texelFetch(rowPlaces, texel, 0);
  uvec4 pair = texelFetch(rowAttributes, ivec2(texel.x / 2, texel.y), 0);
  attributes = texel.x % 2 == 0 ? pair.xy : pair.zw;
}

void findCorner() {
  int number = gl_VertexID % 4;
  corner = vec2(number == 1 || number == 2 ? 1.0 : -1.0, number < 2 ? -1.0 : 1.0);
}

// Reads a row by vertex number.
void readRow() {
  fetchRow(gl_VertexID / rowVertices);
  findCorner();
}
