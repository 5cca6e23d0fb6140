precision highp float;
precision highp sampler2D;

// Copies the host's shadowed scene from a target with stencil into a target without one, in screen space. Outputs the
// premultiplied colour of a pixel, where any of its samples is in shadow.
uniform sampler2D picture;
uniform sampler2D surfaceDepth;
uniform vec2 viewportOrigin;
uniform mat4 clipFromView;

out vec4 pixel;

#include ../lib/depth.glsl

// Bound of the error of a 16-bit depth buffer.
const float SLACK = 1.0 / 65536.0;

float depthAt(ivec2 at) {
  return texelFetch(surfaceDepth, clamp(at, ivec2(0), textureSize(surfaceDepth, 0) - 1), 0).r;
}

// A depth in front of the surface at all samples of a pixel. It fails the depth test only behind objects that are not in
// the picture, such as other smoke.
float frontDepth(ivec2 at) {
  float order = depthOrder(clipFromView);
  float front = order * depthAt(at);
  for (int side = -1; side <= 1; side += 2) {
    front = min(front, order * depthAt(at + ivec2(side, 0)));
    front = min(front, order * depthAt(at + ivec2(0, side)));
  }
  return order * (front - SLACK);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy - viewportOrigin);
  pixel = texelFetch(picture, at, 0);
  if (pixel.a == 0.0) discard;
  gl_FragDepth = frontDepth(at);
}
