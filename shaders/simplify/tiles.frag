precision highp float;
precision highp int;

// The field of each tile of 8 x 8 pixels: one fragment for each. Where pixels differ, the share of light is 1/2, which no
// pixel has.
uniform sampler2D fields;

out vec4 field;

#include flatTiles.glsl

void main() {
  ivec2 start = FLAT_TILE * ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(fields, 0) - 1;
  field = texelFetch(fields, start, 0);
  for (int y = 0; y < FLAT_TILE; y++) {
    for (int x = 0; x < FLAT_TILE; x++) {
      if (texelFetch(fields, min(start + ivec2(x, y), last), 0) != field) {
        field = vec4(0.5);
        return;
      }
    }
  }
}
