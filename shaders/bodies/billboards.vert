precision highp float;
precision highp int;

// The body of a billboard particle: a nailboard parallel to the image plane that covers the puff and its ring of ink, and rolls
// with it.
// Rows are in world space; outputs are in view space or in puff radii.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform vec4 lightInView;
uniform float near;
uniform float inkPixels;
uniform float inkSwell;
uniform int drawing;
uniform float innerLine;
uniform vec3 gradientWeights;
uniform sampler2D ramps;

out vec2 puffPoint;
out float gradientPosition;
flat out int variation;
flat out vec2 rollRotation;
flat out float inkReach;
flat out float phase;
flat out float centreZ;
flat out float radius;
flat out float ringDrop;
flat out float rampIndex;
flat out vec3 towardsLight;

#include ../lib/rows.glsl
#include ../lib/clearance.glsl
#include ../lib/light.glsl
#include ../lib/pixel.glsl
#include ../lib/ink.glsl
#include ../lib/attributes.glsl
#include ../lib/material.glsl
#include ../silhouettes/support.glsl
#ifdef FALLOFF
float packedStrengthAt(vec3 place);
#include ../lib/srgb.glsl
#endif

void main() {
  readRow();
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  radius = place.w * clearance(centre, 1.0);
  float pixel = viewUnitsPerPixel(clipFromView, viewport, centre.z);
  phase = boilPhase(seedOf(attributes), drawing);
  rampIndex = materialOf(attributes, ramps);
  float line = inkPixels * exp2(inkSwell);
#ifdef LOOKS
  line *= inkWeightOf(rampIndex);
#endif
  inkReach = radius > 0.0 ? lineWidth(line, radius / pixel) * pixel / radius : 0.0;
  variation = variationOf(attributes) % textureSize(supports, 0).y;
  int quarter = textureSize(supports, 0).x / 4;
  float right = supportAt(corner.x > 0.0 ? 0 : 2 * quarter, variation);
  float up = supportAt(corner.y > 0.0 ? quarter : 3 * quarter, variation);
  puffPoint = corner * (vec2(right, up) + inkReach);
  rollRotation = vec2(cos(rollOf(attributes)), sin(rollOf(attributes)));
  vec2 point = vec2(rollRotation.x * puffPoint.x - rollRotation.y * puffPoint.y, rollRotation.y * puffPoint.x + rollRotation.x * puffPoint.y);
  centreZ = centre.z;
  ringDrop = innerLine * radius;
  towardsLight = towardsLightFrom(lightInView, centre);
#ifdef FALLOFF
  rampIndex += packedStrengthAt(place.xyz);
#endif
  vec4 clip = clipFromView * vec4(centre + vec3(point * radius, 0.0), 1.0);
  gradientPosition = dot(gradientWeights, vec3(0.5 + 0.5 * point.y, 0.5 + 0.5 * clip.y / clip.w, 1.0 - ageOf(attributes)));
  // Fragments write the depth. A constant here keeps the near plane from clipping the quad.
  gl_Position = centre.z < -near && radius > 0.0 ? vec4(clip.xy, 0.0, clip.w) : vec4(0.0, 0.0, 2.0, 1.0);
}
