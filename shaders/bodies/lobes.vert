precision highp float;
precision highp int;

// The body of a particle whose puff is met per pixel: turns the lobes into the view, and lays a nailboard parallel to the
// image plane round their silhouette and its ring of ink. Lobes are in view space, in puff radii about the centre.
// FLAT: for GPUs that do not keep a depth that fragments write. Two quads then, each as deep as it is drawn: the puff
// through its centre, and after it the ink, which lies deeper.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform float near;
uniform float inkPixels;
uniform float inkSwell;
uniform int drawing;
uniform float innerLine;
uniform vec3 gradientWeights;
uniform sampler2D ramps;
// A row for each variation: its LOBES lobes (xyz, radius), then their middle.
uniform sampler2D lobeTable;

in vec2 corner;
in vec4 place;
in uvec2 attributes;

// Three vectors besides the lobes cross to the fragments; every device takes fifteen.
out vec4 pointAndGradient;
flat out vec4 middleAndInkReach;
// View depth of the centre, radius, how far the ring lies deeper; then which ramp.
flat out vec4 depthsAndRamp;
flat out vec4 lobes[LOBES];

#include ../lib/pixel.glsl
#include ../lib/depth.glsl
#include ../lib/ink.glsl
#include ../lib/attributes.glsl
#include ../lib/material.glsl
#include ../lib/orientation.glsl

void main() {
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  // A puff that the eye runs into shrinks away instead of being cut by the near plane.
  float radius = place.w * smoothstep(near, near + 2.0 * place.w, -centre.z);
  float pixel = viewUnitsPerPixel(clipFromView, viewport, centre.z);
  float inkReach = radius > 0.0 ? lineWidth(inkPixels * exp2(inkSwell), radius / pixel) * pixel / radius : 0.0;

  mat3 viewFromPuff = mat3(viewFromWorld) * worldFromPuff(attributes);
  int variation = variationOf(attributes) % textureSize(lobeTable, 0).y;
  vec2 lowest = vec2(0.0);
  vec2 highest = vec2(0.0);
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    lobes[ i ] = texelFetch(lobeTable, ivec2(UNROLLED_LOOP_INDEX, variation), 0);
    lobes[ i ].xyz = viewFromPuff * lobes[ i ].xyz;
    lowest = min(lowest, lobes[ i ].xy - lobes[ i ].w);
    highest = max(highest, lobes[ i ].xy + lobes[ i ].w);
  }
  #pragma unroll_loop_end
  vec3 middle = viewFromPuff * texelFetch(lobeTable, ivec2(LOBES, variation), 0).xyz;

  vec2 point = mix(lowest, highest, 0.5 + 0.5 * corner) + corner * inkReach;
  vec4 clip = clipFromView * vec4(centre + vec3(point * radius, 0.0), 1.0);
  vec3 gradients = vec3(0.5 + 0.5 * point.y, 0.5 + 0.5 * clip.y / clip.w, 1.0 - ageOf(attributes));
  pointAndGradient = vec4(point, dot(gradientWeights, gradients), boilPhase(seedOf(attributes), drawing));
  middleAndInkReach = vec4(middle, inkReach);
  depthsAndRamp = vec4(centre.z, radius, innerLine * radius, materialOf(attributes, ramps));
#ifdef FLAT
  float drop = gl_VertexID > 3 ? depthsAndRamp.z : 0.0;
  clip.z = (2.0 * windowDepth(clipFromView, centre.z - drop) - 1.0) * clip.w;
#else
  // Depth is written by the fragments; a constant here keeps the near plane from cutting the quad.
  clip.z = 0.0;
#endif
  gl_Position = radius > 0.0 ? clip : vec4(0.0, 0.0, 2.0, 1.0);
}
