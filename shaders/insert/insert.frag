precision highp float;
precision highp sampler2D;

// Inserts smoke, drawn by itself, into a picture that others draw: the depth of each pixel, and a premultiplied colour.
// Each depth test against the picture is then one of the picture's own samples, which keeps its edges smooth.
uniform sampler2D picture;
uniform sampler2D smokeDepth;
uniform vec2 viewportOrigin;
uniform bool isLinear;

out vec4 pixel;

#include ../lib/srgb.glsl

float depthAt(ivec2 at) {
  return texelFetch(smokeDepth, clamp(at, ivec2(0), textureSize(smokeDepth, 0) - 1), 0).r;
}

// A smoothed edge reaches one pixel beyond the smoke, where it takes the nearest depth beside it.
float nearestDepth(ivec2 at) {
  float own = depthAt(at);
  if (own < 1.0) return own;
  float level = min(depthAt(at + ivec2(1, 0)), depthAt(at - ivec2(1, 0)));
  float upright = min(depthAt(at + ivec2(0, 1)), depthAt(at - ivec2(0, 1)));
  return min(level, upright);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy - viewportOrigin);
  vec4 color = texelFetch(picture, at, 0);
  if (color.a == 0.0) discard;
  pixel = isLinear ? vec4(linearFromDisplay(color.rgb / color.a) * color.a, color.a) : color;
  gl_FragDepth = nearestDepth(at);
}
