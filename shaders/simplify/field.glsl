// What later passes average of a pixel: share of light; N.L where there is light; state of the shadow: 0 deep, 1/2 plain,
// 1 filled; share of rim.
uniform sampler2D lit;
uniform sampler2D shading;
// N.L from which lit smoke differs from smoke in shadow.
uniform float litFrom;
#ifdef LOOKS
// LOOKS: of each material instead. Added by src/renderer/looks.ts.
uniform sampler2D ramps;
float litBorderOf(sampler2D ramps, float material);
#endif

#include unpackShading.glsl
#include ../lib/mask.glsl

vec4 fieldOf(Shading own, float mask) {
  bool isSmoke = own.radius > 0.0;
#ifdef LOOKS
  float litFrom = litBorderOf(ramps, own.material);
#endif
  float share = isShadowed(mask) || (isSmoke && own.facing < litFrom) ? 0.0 : 1.0;
  float darkness = isDeep(mask) ? 0.0 : own.isFilled ? 1.0 : 0.5;
  return vec4(share, share * own.facing, (1.0 - share) * darkness, float(own.isRim));
}
