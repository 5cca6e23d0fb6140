precision highp float;

// The depth buffer as grey levels: white for the nearest depth of the scene, black for the farthest. Screen space.
uniform sampler2D depth;
uniform mat4 clipFromView;
// View depths that map to white and black.
uniform vec2 depthRange;

out vec4 pixel;

#include ../lib/depth.glsl

void main() {
  float found = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
  float away = (-viewZOf(clipFromView, found) - depthRange.x) / (depthRange.y - depthRange.x);
  pixel = vec4(vec3(found < 1.0 ? clamp(1.0 - away, 0.0, 1.0) : 0.0), 1.0);
}
