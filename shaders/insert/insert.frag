precision highp float;
precision highp sampler2D;

// Composites smoke from its own targets into the host's framebuffer, in screen space. Outputs the depth and the
// premultiplied colour of a pixel. The depth test against the host runs per sample of a multisampled framebuffer, so
// the host's edges stay smooth.
uniform sampler2D picture;
uniform sampler2D smokeDepth;
uniform vec2 viewportOrigin;
uniform bool isLinear;
uniform mat4 clipFromView;
// The projection of the smoke's depth, if that of the host has an oblique near plane.
uniform mat4 smokeProjection;
uniform bool isOblique;
uniform bool isMirrored;
// The host's fog: its colour in the colour space of the framebuffer, and (near, far) or (density, 0), as three.js has them.
uniform int fogKind;
uniform vec3 fogColor;
uniform vec2 fogRange;

out vec4 pixel;

const int LINEAR = 1;

#include ../lib/depth.glsl
#include ../lib/pixel.glsl
#include oblique.glsl
#include ../lib/srgb.glsl
#include toneMapping.glsl

float depthAt(ivec2 at) {
  return texelFetch(smokeDepth, clamp(at, ivec2(0), textureSize(smokeDepth, 0) - 1), 0).r;
}

// A smoothed edge extends one pixel beyond the smoke, where it uses the nearest depth of the neighbours.
float nearestDepth(ivec2 at) {
  float order = depthOrder(clipFromView);
  float nothing = order > 0.0 ? 1.0 : 0.0;
  float own = depthAt(at);
  if (own != nothing) return own;
  vec2 level = vec2(depthAt(at + ivec2(1, 0)), depthAt(at - ivec2(1, 0)));
  vec2 upright = vec2(depthAt(at + ivec2(0, 1)), depthAt(at - ivec2(0, 1)));
  vec2 nearer = order * min(order * level, order * upright);
  return order * min(order * nearer.x, order * nearer.y);
}

// Share of the fog's colour at a view depth.
float fogAt(float depth) {
  float thickness = fogRange.x * depth;
  return fogKind == LINEAR ? smoothstep(fogRange.x, fogRange.y, depth) : 1.0 - exp(-thickness * thickness);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy - viewportOrigin);
  if (isMirrored) at.x = textureSize(picture, 0).x - 1 - at.x;
  vec4 color = texelFetch(picture, at, 0);
  if (color.a == 0.0) discard;
  pixel = color;
  if (isLinear) pixel.rgb = withoutToneMapping(linearFromDisplay(color.rgb / color.a)) * color.a;
  gl_FragDepth = nearestDepth(at);
  if (fogKind != 0) {
    float z = viewZOf(isOblique ? smokeProjection : clipFromView, gl_FragDepth);
    pixel.rgb = mix(pixel.rgb, fogColor * pixel.a, fogAt(-z));
  }
  if (isOblique) {
    mat4 straight = withoutSlant(gl_FragCoord.xy - viewportOrigin, clipFromView, vec2(textureSize(smokeDepth, 0)));
    gl_FragDepth = windowDepth(straight, viewZOf(smokeProjection, gl_FragDepth));
    // In front of the near plane, for example behind a mirror.
    if (gl_FragDepth < 0.0) discard;
  }
}
