precision highp float;
precision highp int;

// The second half of the smoothing, along columns, and the choice of a tone from the smoothed light. Output:
// display-encoded colour, not premultiplied. FALLOFF: where there is smoke, the alpha of the unlit colour is the packed
// strength of the light.
uniform sampler2D unlit;
uniform sampler2D lit;
uniform sampler2D shading;
uniform sampler2D ramps;
uniform vec3 deepShadow;
uniform vec3 gradientFactor;
uniform vec3 rimColor;
uniform vec3 inkColor;
uniform float litFrom;
#if defined(FORM) || defined(ADDITIONAL_LIGHTS)
uniform highp sampler2D depth;
uniform mat4 clipFromView;
uniform vec2 viewport;
#endif
#ifdef FORM
// Of src/renderer/passes/simplify/plumeForm.ts.
uniform highp sampler3D form;
uniform mat4 formFromView;
uniform mat4 viewFromWorld;
uniform vec4 lightInView;
uniform float plumeForm;
#endif

layout(location = 0) out vec4 pixel;

#include unpackShading.glsl
#define ALONG_COLUMNS
#include smoothing.glsl
#include ../lib/srgb.glsl
#ifdef FALLOFF
void unpackStrength(float code);
#endif
#include ../lib/shade.glsl
#if defined(FORM) || defined(ADDITIONAL_LIGHTS)
#include ../lib/depth.glsl
#include ../lib/light.glsl
#include ../lib/pixel.glsl

// The visible point of a pixel, in view space.
vec3 placeAt(ivec2 at) {
  float z = viewZOf(clipFromView, texelFetch(depth, at, 0).r);
  return vec3(viewPointOf(gl_FragCoord.xy, clipFromView, viewport, z), z);
}
#endif

#ifdef LOOKS
float litToneOf(sampler2D ramps, float material);
#endif

vec3 rampAt(float material, float row, float facing) {
#if defined(FALLOFF) || defined(LOOKS)
  ivec2 texel = rampTexel(material, row, clamp(256.0 * facing, 0.0, 255.0));
#endif
#ifdef FALLOFF
  if (row == 1.0 || row == 3.0) return inLight(texel, false);
#endif
#ifdef LOOKS
  return texelFetch(ramps, texel, 0).rgb;
#endif
  float pitch = 1.0 / float(textureSize(ramps, 0).y);
  return textureLod(ramps, vec2(facing, (RAMP_ROWS * material + row + 0.5) * pitch), 0.0).rgb;
}

#ifdef FORM
// The share of light of a pixel of smoke, mixed with that of the form of the whole smoke.
float leaningShare(float share, float facing) {
  // N.L of the form from which it adds to the light, so that as much of the smoke stays lit.
  const float FORM_MIDDLE = 0.35;
  return mix(share, 0.5 + 0.5 * (facing - FORM_MIDDLE), plumeForm);
}

vec4 leaning(vec4 light, float litFrom, ivec2 at) {
  const float FORM_STEPS = 127.0;
  vec3 place = placeAt(at);
  vec4 texel = texture(form, (formFromView * vec4(place, 1.0)).xyz);
  vec3 outward = (255.0 * texel.xyz - (FORM_STEPS + 1.0)) / FORM_STEPS;
  outward = mat3(viewFromWorld) * outward;
  float facing = dot(outward, towardsLightFrom(lightInView, place));
  float share = leaningShare(light.r, facing);
#ifdef ADDITIONAL_LIGHTS
  lightShares = leaningShares(lightShares, outward, place);
#endif
  float own = light.r > 0.0 ? light.g / light.r : litFrom;
  float darkness = light.r < 1.0 ? light.b / (1.0 - light.r) : 0.5;
  return vec4(share, share * mix(own, facing, plumeForm), (1.0 - share) * darkness, light.a);
}
#endif

// A tone in the additional lights of a pixel of smoke.
vec3 inLights(vec3 tone, float material, ivec2 at) {
#ifdef ADDITIONAL_LIGHTS
  if (max(max(lightShares.x, lightShares.y), lightShares.z) > 0.5 || lightAround != vec3(0.0)) {
    return lightened(tone, reflected(material, lightOf(lightShares, placeAt(at))));
  }
#endif
  return tone;
}

// The tone that the averaged fields select, without the gradient.
vec3 toneOf(vec4 light, float litFrom, float material) {
  if (light.r > 0.5) return rampAt(material, 1.0, max(light.g / light.r, litFrom));
  float darkness = light.b / (1.0 - light.r);
  vec3 shadow = rampAt(material, darkness > 0.75 ? 2.0 : 0.0, 0.0);
  return darkness < 0.25 ? shadow * deepShadow : shadow;
}

#ifdef AMOUNTS
void print(float amount, float ink, float radius);
void printSurface(vec4 shadowed, vec4 direct, float shadow);
float amountOn(float lit, float facing);
#endif

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 shadowed = texelFetch(unlit, at, 0);
  vec4 direct = texelFetch(lit, at, 0);
  vec4 packed = texelFetch(shading, at, 0);
  Shading own = unpackShading(packed);
#ifdef FALLOFF
  if (own.radius > 0.0) {
    unpackStrength(shadowed.a);
    shadowed.a = 1.0;
  }
#endif
  // A tile at the border of the picture reaches into the next one.
  if (texelFetch(flatTiles, at / FLAT_TILE, 0).g < 0.5) discard;
  vec4 light = smoothedAt(at, ivec2(0, 1), LINKED_ABOVE);
#ifdef AMOUNTS
  if (own.radius == 0.0) printSurface(shadowed, direct, 1.0 - light.r);
  else print(0.0, own.isInk ? direct.b : 0.0, packed.a);
#endif
  vec3 gradient = shadowed.rgb * mix(gradientFactor, vec3(1.0), unpackPosition(direct.rg));
  if (own.isInk) {
    float row = own.isFilled ? 2.0 : 0.0;
#ifdef ADDITIONAL_LIGHTS
    lightShares = sharesOf(unpackLights(direct.rg));
#endif
    vec3 dark = inLights(rampAt(own.material, row, own.facing), own.material, at);
    vec3 bright = inLights(rampAt(own.material, row + 1.0, own.facing), own.material, at);
    shadowed.rgb = mix(dark * gradient, inkColor, direct.b);
    direct.rgb = mix(bright * gradient, inkColor, direct.b);
  }
  if (own.radius == 0.0 || own.isInk) {
    vec3 shadow = light.b < 0.25 * (1.0 - light.r) ? shadowed.rgb * deepShadow : shadowed.rgb;
    pixel = vec4(light.r > 0.5 ? direct.rgb : shadow, shadowed.a);
    return;
  }
  if (light.a > 0.5) {
#ifdef FALLOFF
    vec3 rim = inLight(ivec2(0), true);
#else
    vec3 rim = rimColor;
#endif
    pixel = vec4(rimOf(rim, ramps, own.material), shadowed.a);
    return;
  }
  float border = litFrom;
#ifdef LOOKS
  border = litToneOf(ramps, own.material);
#endif
#ifdef FORM
  light = leaning(light, border, at);
#endif
#ifdef AMOUNTS
  print(amountOn(light.r, light.g / max(light.r, 0.001)), 0.0, packed.a);
#endif
  vec3 tone = inLights(toneOf(light, border, own.material), own.material, at);
  pixel = vec4(min(tone * gradient, 1.0), shadowed.a);
}
