precision highp float;
precision highp int;

// The body of a lobe particle: transforms the lobes to view space, and places a nailboard parallel to the image plane
// around their silhouette and its ring of ink. Output lobes are in puff radii about the centre.
// FLAT: for GPUs that do not keep the depth that fragments write. Two quads are drawn, each with its own depth: the
// puff through its centre, and after it the ink, which is deeper.
// CUT: puffs with bites; src/renderer/bites.ts adds bites/lobesVertex.glsl.
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
// One row for each variation: LOBES lobes (xyz, radius), then the mean of their centres, weighted by volume.
uniform sampler2D lobeTable;

// Three vectors besides the lobes are passed to the fragment shader; every WebGL2 device has at least fifteen.
out vec4 pointAndGradient;
flat out vec4 middleAndInkReach;
// View z of the centre, radius, depth offset of the ring, and ramp index. DEFORMED: the packed stretch instead of the offset,
// and the radius is the one across the stretch. Points and lobes are those of stretch.glsl. FALLOFF: the ramp index plus the
// packed strength of the light.
flat out vec4 depthsAndRamp;
flat out vec4 lobes[LOBES];

#include ../lib/rows.glsl
#include ../lib/clearance.glsl
#include ../lib/pixel.glsl
#include ../lib/depth.glsl
#include ../lib/ink.glsl
#include ../lib/attributes.glsl
#include ../lib/material.glsl
#include ../lib/orientation.glsl
#ifdef FALLOFF
float packedStrengthAt(vec3 place);
#include ../lib/srgb.glsl
#endif
#ifdef CUT
mat2x3 bitesIn(mat3 viewFromPuff);
void cutLobes(mat2x3 bites, out vec2 lowest, out vec2 highest);
#endif

void main() {
  readRow();
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  float across = 1.0;
#ifdef DEFORMED
  vec4 stretch = stretchOf(attributes.w);
  across = acrossOf(stretch.w);
#endif
  float radius = place.w * across * clearance(centre, across);
  float pixel = viewUnitsPerPixel(clipFromView, viewport, centre.z);
  float rampIndex = materialOf(attributes, ramps);
  float line = inkPixels * exp2(inkSwell);
#ifdef LOOKS
  line *= inkWeightOf(rampIndex);
#endif
  float inkReach = radius > 0.0 ? lineWidth(line, radius / pixel) * pixel / radius : 0.0;

  mat3 viewFromPuff = mat3(viewFromWorld) * worldFromPuff(attributes);
#ifdef DEFORMED
  Projection projection = projectionOf(vec4(mat3(viewFromWorld) * stretch.xyz, stretch.w));
#endif
  int variation = variationOf(attributes) % textureSize(lobeTable, 0).y;
  vec2 lowest = vec2(0.0);
  vec2 highest = vec2(0.0);
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    lobes[ i ] = texelFetch(lobeTable, ivec2(UNROLLED_LOOP_INDEX, variation), 0);
#ifdef DEFORMED
    lobes[ i ].xyz *= unfolded(UNROLLED_LOOP_INDEX, ageOf(attributes));
#endif
    lobes[ i ].xyz = viewFromPuff * lobes[ i ].xyz;
#ifdef DEFORMED
    lobes[ i ].xyz = unstretched(projection, lobes[ i ].xyz / across);
#endif
    lowest = min(lowest, lobes[ i ].xy - lobes[ i ].w);
    highest = max(highest, lobes[ i ].xy + lobes[ i ].w);
  }
  #pragma unroll_loop_end
#ifdef DEFORMED
  vec4 sum = vec4(0.0);
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    sum += vec4(lobes[ i ].xyz, 1.0) * (lobes[ i ].w * lobes[ i ].w * lobes[ i ].w);
  }
  #pragma unroll_loop_end
  vec3 middle = sum.xyz / sum.w;
#else
  vec3 middle = viewFromPuff * texelFetch(lobeTable, ivec2(LOBES, variation), 0).xyz;
#endif
#ifdef CUT
  mat2x3 bites = bitesIn(viewFromPuff);
#ifdef DEFORMED
  bites = mat2x3(unstretched(projection, bites[0] / across), unstretched(projection, bites[1] / across));
#endif
  cutLobes(bites, lowest, highest);
#endif

  vec2 margin = corner * inkReach;
#ifdef DEFORMED
  // A line lies within its width along the gradient of the distance: these are the extents of its points about a lobe.
  float squared = projection.factor * projection.factor;
  float along = squared < 0.5 ? 0.5 * inversesqrt(1.0 - squared) : projection.factor;
  margin *= min(vec2(1.0), along * abs(projection.along) + abs(projection.along.yx));
#endif
  vec2 point = mix(lowest, highest, 0.5 + 0.5 * corner) + margin;
  vec2 beside = point;
#ifdef DEFORMED
  beside = scaled(projection, point, 1.0 / projection.factor);
#endif
  vec4 clip = clipFromView * vec4(centre + vec3(beside * radius, 0.0), 1.0);
  vec3 gradients = vec3(0.5 + 0.5 * beside.y, 0.5 + 0.5 * clip.y / clip.w, 1.0 - ageOf(attributes));
  pointAndGradient = vec4(point, dot(gradientWeights, gradients), boilPhase(seedOf(attributes), drawing));
  middleAndInkReach = vec4(middle, inkReach * exp2(-inkSwell));
  depthsAndRamp = vec4(centre.z, radius, innerLine * radius, rampIndex);
#ifdef FALLOFF
  depthsAndRamp.w += packedStrengthAt(place.xyz);
#endif
#ifdef DEFORMED
  // The fragment shader computes the same projection; interpolating it would take vectors that not every device has.
  depthsAndRamp.z = float(attributes.w & 0xffffffu);
#endif
#ifdef FLAT
  float drop = gl_VertexID % 8 > 3 ? innerLine * radius : 0.0;
  clip.z = (2.0 * windowDepth(clipFromView, centre.z - drop) - 1.0) * clip.w;
#else
  // Fragments write the depth. A constant here keeps the near plane from clipping the quad.
  clip.z = 0.0;
#endif
  gl_Position = centre.z < -near && radius > 0.0 ? clip : vec4(0.0, 0.0, 2.0, 1.0);
}
