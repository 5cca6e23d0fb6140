// Lights besides the key light, without shadow, see docs/design/rendering.md. src/renderer/additionalLights.ts adds this to
// shaders with ADDITIONAL_LIGHTS, which include srgb.glsl and shade.glsl. A set of lights is a number with one bit for each.
uniform int lightCount;
// View space: (unit vector towards a sun, 0) or (place of a lamp, 1).
uniform vec4 lights[3];
// Factors on the direct light.
uniform vec3 lightColors[3];
// See reachOf.
uniform vec4 lightReaches[3];
uniform vec4 lightCones[3];
// Light of those that are beyond the number, from all sides.
uniform vec3 lightAround;

#include ../falloff/reach.glsl


vec3 wayTo(int light, vec3 place) {
  return lights[light].xyz - lights[light].w * place;
}

// N.L of a light. Both are in view space.
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

// A tone of a ramp, display-encoded, plus C KL of Eq. 2 for each light whose share of the surface is more than a half: the
// difference of full light and of shadow.
vec3 lightened(vec3 tone, float material, vec3 shares, vec3 place) {
  vec3 sum = lightAround;
  for (int light = 0; light < lightCount; light++) {
    if (shares[light] > 0.5) sum += lightColors[light] * reachOf(wayTo(light, place), lightReaches[light], lightCones[light]);
  }
  int first = int(RAMP_ROWS * material);
  vec4 shadow = texelFetch(styledRamps, ivec2(0, first), 0);
  vec3 full = texelFetch(styledRamps, ivec2(RAMP_TEXELS - 1.0, first + 1), 0).rgb;
  // Alpha is the share that glows, which no light changes.
  vec3 added = max(full - shadow.rgb, 0.0) * (1.0 - shadow.a) * sum;
  return added == vec3(0.0) ? tone : displayFromLinear(min(linearFromDisplay(tone) + added, 1.0));
}
