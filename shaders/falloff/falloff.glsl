// Direct light that weakens with the distance from a lamp, see docs/design/rendering.md. src/renderer/falloff.ts adds this to
// shaders with FALLOFF, which include srgb.glsl.
uniform vec3 lampPlace;
// Factors on the direct light where the strength is 1, the largest of which is 1, and on the ambient light.
uniform vec3 lampLight;
uniform vec3 ambientLight;
// Linear colour of the rim where the strength is 1.
uniform vec3 lampRim;
uniform float lampStrength;
// See reachOf.
uniform vec4 lampReach;
uniform vec4 lampCone;

// Ramps in the light of the style, linear.
uniform sampler2D styledRamps;

#include reach.glsl

// Strength of the direct light where the shader is.
float strength;

// @param place in the world
float strengthAt(vec3 place) {
  return lampStrength * reachOf(lampPlace - place, lampReach, lampCone);
}

// The strength at a place as a number below 1. In 8 bits, tones up to white are exact to 2 of 255.
float packedStrengthAt(vec3 place) {
  float power = pow(strengthAt(place), 2.0 / 3.0);
  return min(power / (1.0 + power), 0.997);
}

void unpackStrength(float code) {
  float power = code / (1.0 - code);
  strength = power * sqrt(power);
}

// Reads the strength from the fraction of a ramp index. Returns it packed.
float takeStrength(inout float material) {
  float code = fract(material);
  material = floor(material);
  unpackStrength(code);
  return code;
}

void findStrength(vec3 place) {
  strength = strengthAt(place);
}

// S a + (T - S) k f for a texel T of the ramps, linear, and the share of T that glows instead. Its alpha is the share of the fill
// light, which stays.
vec3 linearInLight(ivec2 texel) {
  int first = texel.y & ~3;
  vec4 tone = texelFetch(styledRamps, texel, 0);
  vec4 shadow = texelFetch(styledRamps, ivec2(texel.x & ~255, first), 0);
  vec3 ambient = shadow.rgb;
  vec3 byFill = tone.a * (texelFetch(styledRamps, ivec2(texel.x & ~255, first + 2), 0).rgb - ambient);
  vec3 color = ambient * ambientLight + (tone.rgb - ambient - byFill) * lampLight * strength + byFill;
  return mix(color, tone.rgb, shadow.a);
}

// The display-encoded colour of a texel, or that of the rim. One encoding for both, because it costs most.
vec3 inLight(ivec2 texel, bool isRim) {
  return displayFromLinear(clamp(isRim ? lampRim * strength : linearInLight(texel), 0.0, 1.0));
}
