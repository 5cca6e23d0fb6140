precision highp float;
precision highp int;

// The stroke at each sample of an arc: a row of samples that are separate from the smoke behind.
flat in int arc;

// Both ends of the stroke, -1..1 as 0..65535, and its opacity, 0..1 as 0..65535. Without a stroke both ends are 0.
layout(location = 0) out uvec4 stroke;

uniform sampler2D separations;

#include tile.glsl

// Averages at which a stroke begins and is complete. A row of samples of length l gives 1 - (1 - l / (2 reach))^2, so that a
// stroke has at least 12 CSS pixels, and is no straight dash.
const vec2 AVERAGES = vec2(0.34, 0.95);

float texelAt(int number) {
  return texelFetch(separations, texelOf(arc, number), 0).r;
}

// The separation at a sample, averaged with its neighbours. The average closes narrow gaps, such as where a line of smoke behind meets the outline.
float smoothedSeparation(int number) {
  const int TAPS = 1;
  float sum = 0.0;
  for (int i = -TAPS; i <= TAPS; i++) {
    float weight = float(TAPS + 1 - abs(i));
    sum += weight * texelAt(clamp(number + i, 0, LAST));
  }
  return sum / float((TAPS + 1) * (TAPS + 1));
}

// The average separation about a place on the arc. The arc is as long as 2 in `along`.
float averageSeparation(float along) {
  float reach = 2.0 * REACH_OF_ARC / texelAt(REACH_TEXEL);
  float sum = 0.0;
  for (int i = 0; i <= LAST; i++) {
    float weight = max(0.0, 1.0 - abs(alongOf(i) - along) / reach);
    sum += weight * texelAt(i);
  }
  return sum * 2.0 / (float(LAST) * reach);
}

// The end of the row of a sample, where the separation falls below 1/2.
float endFrom(int number, int way) {
  float last = smoothedSeparation(number);
  float end = alongOf(number);
  for (int i = number + way; i >= 0 && i <= LAST; i += way) {
    float next = smoothedSeparation(i);
    end += (alongOf(i) - end) * (next < 0.5 ? (last - 0.5) / (last - next) : 1.0);
    last = next;
    if (next < 0.5) break;
  }
  return end;
}

void main() {
  int number = numberOf(arc, gl_FragCoord.xy);
  stroke = uvec4(0u);
  if (number > LAST || smoothedSeparation(number) < 0.5) return;
  vec2 ends = vec2(endFrom(number, -1), endFrom(number, 1));
  // Not a smoothstep, which is steeper.
  float average = averageSeparation(0.5 * (ends.x + ends.y));
  float opacity = texelAt(OPACITY_TEXEL) * clamp((average - AVERAGES.x) / (AVERAGES.y - AVERAGES.x), 0.0, 1.0);
  stroke = uvec4(round(65535.0 * vec4(0.5 + 0.5 * ends, opacity, 0.0)));
}
