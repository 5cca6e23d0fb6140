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

vec3 wayTo(int light, vec3 place) {
  return LIGHTS[light].xyz - LIGHTS[light].w * place;
}

// N.L of a light.
float facingOf(int light, vec3 normal, vec3 place) {
  return dot(normal, normalize(wayTo(light, place)));
}

// The lights whose N.L is above a border.
int lightsOn(vec3 normal, vec3 place, float border) {
  int all = 0;
  for (int light = 0; light < lightCount; light++) {
    if (facingOf(light, normal, place) > border) all |= 1 << light;
  }
  return all;
}

// 1 for each light of a set.
vec3 sharesOf(int all) {
  return vec3(all & 1, (all >> 1) & 1, (all >> 2) & 1);
}

vec3 lightFrom(int light, vec3 place) {
  return lightColors[light] * reachOf(wayTo(light, place), lightReaches[light], CONES[light]);
}

// The sum of the lights whose share of a place is more than a half.
vec3 lightOf(vec3 shares, vec3 place) {
  vec3 sum = lightAround;
  for (int light = 0; light < lightCount; light++) {
    if (shares[light] > 0.5) sum += lightFrom(light, place);
  }
  return sum;
}

// The sum of the lights whose N.L is above a border.
vec3 lightOn(vec3 normal, vec3 place, float border) {
  vec3 sum = lightAround;
  for (int light = 0; light < lightCount; light++) {
    if (facingOf(light, normal, place) > border) sum += lightFrom(light, place);
  }
  return sum;
}

// C KL of Eq. 2 for a sum of lights: KL C is the difference of full light and of shadow. Linear.
vec3 reflected(float material, vec3 sum) {
  int first = int(RAMP_ROWS * material);
  vec4 shadow = texelFetch(styledRamps, ivec2(0, first), 0);
  vec3 full = texelFetch(styledRamps, ivec2(RAMP_TEXELS - 1.0, first + 1), 0).rgb;
  // Alpha is the share that glows, which no light changes.
  return max(full - shadow.rgb, 0.0) * (1.0 - shadow.a) * sum;
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
