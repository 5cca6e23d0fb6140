precision highp float;

// Copies the chosen tones. Output: premultiplied display-encoded colour.
out vec4 pixel;

#include ../lib/tones.glsl

void main() {
  vec4 tone = toneAt(ivec2(gl_FragCoord.xy));
  pixel = vec4(tone.rgb * tone.a, tone.a);
}
