precision highp float;
precision highp int;

// Marks the tiles of the picture that have pixels with a pattern: red those on smoke, green on other surfaces, blue on the backdrop.
uniform sampler2D amounts;

out vec4 mark;

// Side of a tile, pixels.
const int EDGE_TILE = 8;

void main() {
  ivec2 start = EDGE_TILE * ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(amounts, 0) - 1;
  vec3 most = vec3(0.0);
  for (int y = 0; y < EDGE_TILE; ++y) {
    for (int x = 0; x < EDGE_TILE; ++x) {
      vec4 texel = texelFetch(amounts, min(start + ivec2(x, y), last), 0);
      float onSmoke = float(texel.a > 0.0);
      most = max(most, texel.r * vec3(onSmoke, texel.b, 1.0 - max(onSmoke, texel.b)));
    }
  }
  mark = vec4(greaterThan(most, vec3(0.0)), 1.0);
}
