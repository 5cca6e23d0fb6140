precision highp float;
precision highp int;

// What the pixels of a tile of 8 x 8 have in common: one fragment for each. Output: their field, with IS_SMOKE, IS_RIM and the
// set of lights in alpha. Where pixels differ, the share of light is 1/2, which no pixel has. Pixels that look the same in
// light and shadow, such as lines and the background, do not count; a tile of them has ANY_LIGHT.
uniform sampler2D unlit;

out vec4 kind;

#include field.glsl
#include flatTiles.glsl

const float IS_SMOKE = 128.0;
const float IS_RIM = 64.0;

void main() {
  ivec2 start = FLAT_TILE * ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(lit, 0) - 1;
  kind = ANY_LIGHT;
  for (int y = 0; y < FLAT_TILE; y++) {
    for (int x = 0; x < FLAT_TILE; x++) {
      ivec2 at = min(start + ivec2(x, y), last);
      vec4 light = texelFetch(lit, at, 0);
      Shading own = unpackShading(texelFetch(shading, at, 0));
      bool isSmoke = own.radius > 0.0;
      if (!isSmoke && light.rgb == texelFetch(unlit, at, 0).rgb) continue;
      vec4 field = fieldOf(own, light.a);
      float bits = field.a * IS_RIM + (isSmoke ? IS_SMOKE : 0.0);
#ifdef ADDITIONAL_LIGHTS
      if (isSmoke) bits += float(unpackLights(light.rg));
#endif
      vec4 found = vec4(field.rgb, bits / 255.0);
      if (kind != ANY_LIGHT && kind != found) {
        kind = vec4(0.5);
        return;
      }
      kind = found;
    }
  }
}
