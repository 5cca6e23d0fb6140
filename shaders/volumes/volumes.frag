precision highp float;
precision highp sampler2D;

// Fragment shader of particle shadow volumes. Tests whether the volume contains the receiver: the place whose depth the
// pixel has. Seen from the light, the receiver must be in the disc of a lobe; along the light, between the start and
// the end of the volume. Each fragment that is not discarded is one volume that contains the receiver.
// CUT: puffs whose shadow is only a part of the discs: see lib/volume.glsl.
// Inputs: volume frame and discs of volumes.vert, a copy of the depth buffer. Output: none, the stencil counts.
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform vec2 viewportOrigin;
uniform sampler2D receiverDepth;

#define VOLUME flat in
#include ../lib/volumeFrame.glsl
#include ../lib/depth.glsl
#include ../lib/pixel.glsl

// Positive in a disc.
float within(vec3 disc, vec2 point) {
  vec2 offset = point - disc.xy;
  return disc.z - dot(offset, offset);
}

#ifdef CUT
bool isLeft(vec2 point);
#endif

void main() {
  float z = viewZOf(clipFromView, texelFetch(receiverDepth, ivec2(gl_FragCoord.xy), 0).r);
  vec3 receiver = vec3(viewPointOf(gl_FragCoord.xy - viewportOrigin, clipFromView, viewport, z), z);
  // The receiver in the frame of the volume, and its projection from the light onto the plane of the discs.
  vec3 place = inFrame(receiver);
  vec2 point = place.xy / scaleAt(place.z);
  float inside = 0.0;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    inside = max(inside, within(discs[ i ], point));
  }
  #pragma unroll_loop_end
  if (!(place.z >= 0.0 && place.z <= rightAndLength.w && inside > 0.0)) discard;
#ifdef CUT
  if (!isLeft(point)) discard;
#endif
}
