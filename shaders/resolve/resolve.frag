precision highp float;

// Chooses between lit and unlit by the mask and smooths the edges: where two flat tones meet along a nearly straight
// line, each pixel beside the line takes as much of the other tone as the line, seen between its two ends, would cover.
// Flat pixels pass through untouched, bit for bit. After the idea of Reshetnikov, 'Morphological Antialiasing' (2009).
uniform sampler2D unlit;
uniform sampler2D lit;
uniform bool smoothEdges;

out vec4 pixel;

#include ../lib/srgb.glsl

// Half a step of an 8-bit channel would be noise; anything an eye sees as an edge is far above this.
const float EDGE = 0.04;
const int LONGEST = 12;

vec4 toneAt(ivec2 at) {
  ivec2 inside = clamp(at, ivec2(0), textureSize(lit, 0) - 1);
  vec4 shadowed = texelFetch(unlit, inside, 0);
  vec4 direct = texelFetch(lit, inside, 0);
  return vec4(mix(direct.rgb, shadowed.rgb, direct.a), shadowed.a);
}

float difference(vec4 a, vec4 b) {
  vec4 gap = abs(a - b);
  return max(max(gap.r, gap.g), max(gap.b, gap.a));
}

// Walks along an edge until either side of it changes. x: steps taken, y: 1 if the edge turned into our own row.
vec2 walk(ivec2 at, ivec2 along, ivec2 across, vec4 own, vec4 other) {
  for (int i = 1; i <= LONGEST; ++i) {
    vec4 ownHere = toneAt(at + i * along);
    vec4 otherHere = toneAt(at + i * along + across);
    if (difference(ownHere, own) > EDGE) return vec2(i, 1.0);
    if (difference(otherHere, other) > EDGE) return vec2(i, 0.0);
  }
  return vec2(LONGEST + 1, 0.0);
}

vec4 blend(vec4 own, vec4 other, float share) {
  float alpha = mix(own.a, other.a, share);
  vec3 light = mix(linearFromDisplay(own.rgb) * own.a, linearFromDisplay(other.rgb) * other.a, share);
  return vec4(displayFromLinear(alpha > 0.0 ? light / alpha : light), alpha);
}

vec4 smoothed(ivec2 at, vec4 own) {
  vec4 north = toneAt(at + ivec2(0, 1));
  vec4 south = toneAt(at - ivec2(0, 1));
  vec4 east = toneAt(at + ivec2(1, 0));
  vec4 west = toneAt(at - ivec2(1, 0));
  float northGap = difference(own, north);
  float southGap = difference(own, south);
  float eastGap = difference(own, east);
  float westGap = difference(own, west);
  float vertical = max(northGap, southGap);
  float horizontal = max(eastGap, westGap);
  if (max(vertical, horizontal) <= EDGE) return own;
  bool level = vertical >= horizontal;
  bool forward = level ? northGap >= southGap : eastGap >= westGap;
  ivec2 across = (level ? ivec2(0, 1) : ivec2(1, 0)) * (forward ? 1 : -1);
  ivec2 along = level ? ivec2(1, 0) : ivec2(0, 1);
  vec4 other = level ? (forward ? north : south) : (forward ? east : west);
  vec2 ahead = walk(at, along, across, own, other);
  vec2 behind = walk(at, -along, across, own, other);
  vec2 nearer = ahead.x < behind.x ? ahead : behind;
  float share = nearer.y * (0.5 - (nearer.x - 0.5) / (ahead.x + behind.x - 1.0));
  return share > 0.0 ? blend(own, other, share) : own;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 tone = toneAt(at);
  if (smoothEdges) tone = smoothed(at, tone);
  pixel = vec4(tone.rgb * tone.a, tone.a);
}
