// The chosen tones of the picture, written by resolve/tones.frag. Tones that differ by at most EDGE count as one.
uniform sampler2D tones;

// Half a step of an 8-bit channel would be noise; every visible edge is far above this threshold.
const float EDGE = 0.04;

vec4 toneAt(ivec2 at) {
  return texelFetch(tones, clamp(at, ivec2(0), textureSize(tones, 0) - 1), 0);
}
