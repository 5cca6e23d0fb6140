// Added to the shaders that choose tones: how much of a pixel the marks of the pattern cover.
uniform float patternCoverage;
uniform float patternBackdrop;
// Whether shadow and tones below full light have marks.
uniform bvec2 patterned;
// N.L from which smoke has its lightest tone.
uniform float fullFrom;
#if !defined(FORM) && !defined(ADDITIONAL_LIGHTS)
uniform highp sampler2D depth;
#endif

// Amount of marks; opacity of ink; 1 on a surface without smoke; radius of the puff.
layout(location = 1) out vec4 printed;

// Shares of shadow between which marks grow, so that they do not appear at once.
const vec2 GROWING = vec2(0.5, 0.8);
// Amount at the border of shadow of marks that end where the lightest tone begins, as a share of that in shadow.
const float BESIDE_SHADOW = 0.6;
// Mask above which a pixel is ink or in shadow.
const float INK = 0.9;

// @param lit share of light
// @param facing mean N.L of what is lit
float amountOn(float lit, float facing) {
  float shadow = patterned.x ? smoothstep(GROWING.x, GROWING.y, 1.0 - lit) : 0.0;
  float tone = patterned.y && lit > 0.5 ? BESIDE_SHADOW * clamp(1.0 - facing / max(fullFrom, 1e-3), 0.0, 1.0) : 0.0;
  return patternCoverage * max(shadow, tone);
}

// @param radius of the puff, as shading.glsl packs it; 0 where there is no smoke
void print(float amount, float ink, float radius) {
  printed = vec4(amount, ink, 0.0, radius);
}

// Of a pixel without smoke, from its colours in shadow and in light: marks are where shadow changes the colour.
void printSurface(vec4 shadowed, vec4 direct, float shadow) {
  float far = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
  bool isBackdrop = far == 0.0 || far == 1.0;
  float height = gl_FragCoord.y / float(textureSize(depth, 0).y);
  float onSurface = shadowed.rgb != direct.rgb && patterned.x ? smoothstep(GROWING.x, GROWING.y, shadow) : 0.0;
  float amount = isBackdrop ? patternBackdrop * height : patternCoverage * onSurface;
  float ink = shadowed.rgb == direct.rgb && direct.a > INK ? 1.0 : 0.0;
  printed = vec4(amount, ink, float(!isBackdrop), 0.0);
}
