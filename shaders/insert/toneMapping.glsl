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

const float NEUTRAL_START = 0.76;
const float NEUTRAL_REST = 1.0 - NEUTRAL_START;

// The greatest channel of the light that Neutral shows with a greatest channel.
float beforeNeutral(float peak) {
  return NEUTRAL_REST * NEUTRAL_REST / (1.0 - peak) - NEUTRAL_REST + NEUTRAL_START;
}

// The share of grey that Neutral mixes into such a colour.
float neutralGrey(float peak) {
  return 1.0 - 1.0 / (0.15 * (beforeNeutral(peak) - peak) + 1.0);
}

// Khronos PBR Neutral. It desaturates bright colours, so none that are bright and saturated have an inverse: they keep their
// hue, as bright as the operator shows it.
vec3 withoutNeutral(vec3 shown) {
  float most = max(shown.r, max(shown.g, shown.b));
  float peak = min(most, NEARLY_WHITE);
  vec3 color = shown;
  if (peak >= NEUTRAL_START) {
    float saturated = min(shown.r, min(shown.g, shown.b)) / most;
    float dark = NEUTRAL_START;
    bool isDarkened = neutralGrey(peak) > saturated;
    for (int i = 0; i < 10 && isDarkened; i++) {
      float middle = 0.5 * (dark + peak);
      if (neutralGrey(middle) > saturated) peak = middle;
      else dark = middle;
    }
    if (isDarkened) color *= (peak = dark) / most;
    float grey = neutralGrey(peak);
    color = max((min(color, peak) - grey * peak) / (1.0 - grey), 0.0) * beforeNeutral(peak) / peak;
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
