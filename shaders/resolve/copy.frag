precision highp float;

// Copies the chosen tones. Output: premultiplied display-encoded colour.
out vec4 pixel;

#include ../lib/tones.glsl
#ifdef MARKS
#include ../lib/srgb.glsl
vec4 withMarks(vec4 color, ivec2 at);
#endif

void main() {
  vec4 tone = toneAt(ivec2(gl_FragCoord.xy));
  pixel = vec4(tone.rgb * tone.a, tone.a);
#ifdef MARKS
  pixel = withMarks(pixel, ivec2(gl_FragCoord.xy));
#endif
}
