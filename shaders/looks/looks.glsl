// Added to shaders with LOOKS: emitters whose smoke has colours, ink and bites of its own; see src/renderer/looks.ts.
// A ramp index is a material plus LOOK_PLACE times the index of a look, which is 0 for smoke without one.
const int LOOK_PLACE = 4096;
const int LOOKS_LIMIT = 16;
// Rows of ramps in a column of the texture.
const int COLUMN_ROWS = 2032;
const int RAMP_WIDTH = 256;

// Factors on the width of lines.
uniform float inkWeights[LOOKS_LIMIT];
// A bit for each look whose bites lie along the stretch of puffs.
uniform int tornLooks;

// @param attributes of a row for the eye
int lookOf(uvec4 attributes) {
  return int(attributes.y >> 28u);
}

// Row of the ramp texture with the bands of a puff.
int bandRowOf(uvec4 attributes, int rows) {
  return rows - LOOKS_LIMIT + lookOf(attributes);
}

float withLook(float material, uvec4 attributes) {
  return material + float(LOOK_PLACE * lookOf(attributes));
}

float withoutLook(float rampIndex) {
  return float(int(rampIndex) % LOOK_PLACE);
}

float inkWeightOf(float rampIndex) {
  return inkWeights[int(rampIndex) / LOOK_PLACE];
}

bool isTornPuff(uvec4 attributes) {
  return (tornLooks >> lookOf(attributes) & 1) != 0;
}

// Where a texel is of which the place is that in one column.
ivec2 inColumns(ivec2 texel) {
  return texel + (texel.y / COLUMN_ROWS) * ivec2(RAMP_WIDTH, -COLUMN_ROWS);
}

// N.L from which lit smoke of a material differs from smoke in shadow.
float litBorderOf(sampler2D ramps, float material) {
  return texelFetch(ramps, inColumns(ivec2(1, 4.0 * material)), 0).a;
}

// The same for selecting a texel of its ramp.
float litToneOf(sampler2D ramps, float material) {
  float texel = round(255.0 * texelFetch(ramps, inColumns(ivec2(2, 4.0 * material)), 0).a);
  return (texel + 0.5) / 256.0;
}
