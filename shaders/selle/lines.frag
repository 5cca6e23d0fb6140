precision highp float;

// Lines one pixel wide where smoke is in front of something deeper, from differences of the depth texture in screen
// space (the method of Deussen and Strothotte for trees, as Selle, Mohr and Chenney applied it to smoke). Output:
// premultiplied display-encoded colour.
uniform sampler2D unlit;
uniform sampler2D lit;
uniform sampler2D depth;
uniform mat4 clipFromView;
uniform vec3 inkColor;
uniform float threshold;

out vec4 pixel;

#include ../lib/depth.glsl

float viewDepthAt(ivec2 at) {
  ivec2 inside = clamp(at, ivec2(0), textureSize(depth, 0) - 1);
  return -viewZOf(clipFromView, texelFetch(depth, inside, 0).r);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 shown = texelFetch(lit, at, 0);
  vec4 tone = vec4(shown.rgb, texelFetch(unlit, at, 0).a);
  if (shown.a > 0.5) {
    float own = viewDepthAt(at);
    float across = max(viewDepthAt(at + ivec2(1, 0)), viewDepthAt(at - ivec2(1, 0)));
    float along = max(viewDepthAt(at + ivec2(0, 1)), viewDepthAt(at - ivec2(0, 1)));
    if (max(across, along) - own > threshold) tone.rgb = inkColor;
  }
  pixel = vec4(tone.rgb * tone.a, tone.a);
}
