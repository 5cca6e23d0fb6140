// Rows of the simulator: src/renderer/gpu/drawnRows.ts. Call fetchRow first.
uniform highp sampler2D rowPlaces;
uniform highp usampler2D rowAttributes;

// World position and radius.
vec4 place;
// See attributes.glsl.
uvec4 attributes;

void fetchRow(int row) {
  int perLine = textureSize(rowPlaces, 0).x;
  ivec2 texel = ivec2(row % perLine, row / perLine);
  place = texelFetch(rowPlaces, texel, 0);
  attributes = texelFetch(rowAttributes, texel, 0);
}
