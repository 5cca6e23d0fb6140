// How the light falls on a pixel of smoke, 8 bits a channel: N.L; material, low byte; material, high bits, and flags;
// radius of the puff, on a logarithmic scale, and 0 where there is no smoke.
struct Shading {
  float facing;
  float material;
  bool isFilled;
  bool isRim;
  bool isInk;
  float radius;
};

// Materials are below 4096: at most 16 by 16 bands, the tints and the surfaces.
const float MATERIALS_HIGH = 16.0;
// Range of the base 2 logarithm of the radius, metres.
const vec2 LOG_RADII = vec2(-10.0, 6.0);

// The radius from its channel of a texel.
float radiusOf(float packed) {
  return packed > 0.0 ? exp2(mix(LOG_RADII.x, LOG_RADII.y, packed)) : 0.0;
}

// The two colours of a pixel of smoke hold what does not depend on the light instead: the unlit one the colour C of Eq. 2,
// and the lit one the position along the gradient in two bytes of red and green, and the opacity of ink in blue. FALLOFF: the alpha of
// the unlit one is the strength of the light, see falloff/falloff.glsl. ADDITIONAL_LIGHTS: the lowest three bits of the position
// are a set of lights, see additionalLights/additionalLights.glsl.
vec2 packBytes(float number) {
  float high = floor(number / 256.0);
  return vec2(high, number - 256.0 * high) / 255.0;
}

#ifdef ADDITIONAL_LIGHTS
const float LIGHT_SETS = 8.0;

vec2 packPosition(float position, int lights) {
  return packBytes(LIGHT_SETS * floor(8191.0 * position + 0.5) + float(lights));
}

float unpackPosition(vec2 bytes) {
  float number = floor(dot(bytes, vec2(65280.0, 255.0)) + 0.5);
  return floor(number / LIGHT_SETS) / 8191.0;
}

int unpackLights(vec2 bytes) {
  return int(255.0 * bytes.g + 0.5) & 7;
}
#else
vec2 packPosition(float position) {
  return packBytes(floor(65535.0 * position + 0.5));
}

float unpackPosition(vec2 bytes) {
  return dot(bytes, vec2(65280.0, 255.0)) / 65535.0;
}
#endif

vec4 packShading(Shading shading) {
  float flags = float(shading.isFilled) + 2.0 * float(shading.isRim) + 4.0 * float(shading.isInk);
  float high = floor(shading.material / 256.0);
  float size = (log2(shading.radius) - LOG_RADII.x) / (LOG_RADII.y - LOG_RADII.x);
  vec3 bytes = vec3(shading.material - 256.0 * high, MATERIALS_HIGH * high + flags, max(1.0, 255.0 * size));
  return vec4(shading.facing, bytes / 255.0);
}
