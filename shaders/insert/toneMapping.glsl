// The inverses of three.js's tone mapping operators that have one. In: linear colour that is to be shown, 0 to 1. Out: the
// linear light that the operator maps to it.

// Of three.js; 0 for none, and for operators without an inverse.
uniform int toneMapping;
uniform float toneMappingExposure;

const int LINEAR_TONES = 1;
const int REINHARD_TONES = 2;
const int CINEON_TONES = 3;
const int NEUTRAL_TONES = 7;
// No light is mapped to white by operators that only approach it. A display shows this value as white.
const float NEARLY_WHITE = 0.998;

// Filmic operator of Hejl and Burgess-Dawson: the positive root of a quadratic equation.
vec3 withoutCineon(vec3 shown) {
  vec3 value = pow(min(shown, NEARLY_WHITE), vec3(1.0 / 2.2));
  vec3 square = 6.2 * (1.0 - value);
  vec3 line = 0.5 - 1.7 * value;
  return (sqrt(line * line + 0.24 * square * value) - line) / (2.0 * square) + 0.004;
}

// Khronos PBR Neutral. It desaturates bright colours, so none that are bright and saturated have an inverse.
vec3 withoutNeutral(vec3 shown) {
  const float START = 0.76;
  const float REST = 1.0 - START;
  const float DESATURATION = 0.15;
  float peak = min(max(shown.r, max(shown.g, shown.b)), NEARLY_WHITE);
  vec3 color = shown;
  if (peak >= START) {
    float before = REST * REST / (1.0 - peak) - REST + START;
    float grey = 1.0 - 1.0 / (DESATURATION * (before - peak) + 1.0);
    color = max((min(shown, peak) - grey * peak) / (1.0 - grey), 0.0) * before / peak;
  }
  float least = min(color.r, min(color.g, color.b));
  return color + (least < 0.04 ? 0.4 * sqrt(least) - least : 0.04);
}

vec3 withoutToneMapping(vec3 shown) {
  if (toneMapping == LINEAR_TONES) return shown / toneMappingExposure;
  if (toneMapping == REINHARD_TONES) {
    vec3 below = min(shown, NEARLY_WHITE);
    return below / (1.0 - below) / toneMappingExposure;
  }
  if (toneMapping == CINEON_TONES) return withoutCineon(shown) / toneMappingExposure;
  if (toneMapping == NEUTRAL_TONES) return withoutNeutral(shown) / toneMappingExposure;
  return shown;
}
