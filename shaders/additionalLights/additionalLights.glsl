// Lights besides the key light, without shadow, see docs/design/rendering.md. src/renderer/additionalLights.ts adds this to
// shaders with ADDITIONAL_LIGHTS, which include shade.glsl. A set of lights is a number with one bit for each.
// Places are in view space, with LIGHTS_IN_WORLD in world space.
#ifdef LIGHTS_IN_WORLD
#define LIGHTS worldLights
#define CONES worldCones
#else
#define LIGHTS lights
#define CONES lightCones
#endif
// (unit vector towards a sun, 0) or (place of a lamp, 1).
uniform vec4 LIGHTS[3];
// Factors on the direct light.
uniform vec3 lightColors[3];
// See reachOf.
uniform vec4 lightReaches[3];
uniform vec4 CONES[3];

#include ../falloff/reach.glsl

// C KL of Eq. 2 of each material, linear: the difference of full light and of shadow. What glows takes less.
uniform highp sampler2D directParts;

vec3 wayTo(vec4 light, vec3 place) {
  return light.xyz - light.w * place;
}

// N.L of a light.
float facingOf(vec4 light, vec3 normal, vec3 place) {
  return dot(normal, normalize(wayTo(light, place)));
}

// Loops are unrolled, because dynamic indexing is slow on some devices.

// The lights whose N.L is above a border.
int lightsOn(vec3 normal, vec3 place, float border) {
  int all = 0;
  #pragma unroll_loop_start
  for (int i = 0; i < 3; i++) {
    if (UNROLLED_LOOP_INDEX < lightCount && facingOf(LIGHTS[ i ], normal, place) > border) all += 1 << UNROLLED_LOOP_INDEX;
  }
  #pragma unroll_loop_end
  return all;
}

// 1 for each light of a set.
vec3 sharesOf(int all) {
  return vec3(all & 1, (all >> 1) & 1, (all >> 2) & 1);
}

#ifdef FORM
// The shares of lights, mixed with those of a whole form.
vec3 leaningShares(vec3 shares, vec3 normal, vec3 place) {
  #pragma unroll_loop_start
  for (int i = 0; i < 3; i++) {
    if (UNROLLED_LOOP_INDEX < lightCount) shares[ i ] = leaningShare(shares[ i ], facingOf(LIGHTS[ i ], normal, place));
  }
  #pragma unroll_loop_end
  return shares;
}
#endif

// The sum of the lights whose share of a place is more than a half.
vec3 lightOf(vec3 shares, vec3 place) {
  vec3 sum = lightAround;
  #pragma unroll_loop_start
  for (int i = 0; i < 3; i++) {
    if (UNROLLED_LOOP_INDEX < lightCount && shares[ i ] > 0.5) {
      sum += lightColors[ i ] * reachOf(wayTo(LIGHTS[ i ], place), lightReaches[ i ], CONES[ i ]);
    }
  }
  #pragma unroll_loop_end
  return sum;
}

vec3 reflected(float material, vec3 sum) {
  const int PARTS_WIDTH = 1024;
  ivec2 texel = ivec2(int(material) % PARTS_WIDTH, int(material) / PARTS_WIDTH);
  return texelFetch(directParts, texel, 0).rgb * sum;
}

// A display-encoded tone plus linear light. Polynomials are exact to 0.7 of 255; the powers of srgb.glsl would cost most.
vec3 lightened(vec3 tone, vec3 light) {
  vec3 linear = tone * (0.0602534 + tone * (0.3477952 + tone * (0.9497423 - tone * 0.3636146)));
  linear = min(linear + light, 1.0);
  vec3 second = sqrt(linear);
  vec3 fourth = sqrt(second);
  vec3 color = 0.643435 * second + 0.7112926 * fourth - 0.3366103 * sqrt(fourth) - 0.0181513 * linear;
  return mix(12.92 * linear, color, step(0.0031308, linear));
}
