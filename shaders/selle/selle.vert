precision highp float;
precision highp int;
precision highp sampler2DArray;

// A puff as Selle, Mohr and Chenney drew it (2004): a flat quad parallel to the image plane, at one depth. Rows are in
// world space, `puffPoint` is in puff radii.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform sampler2D ramps;
uniform sampler2DArray colorCoverage;

out vec2 puffPoint;
flat out int variation;
flat out float material;

#include ../lib/rows.glsl
#include ../lib/attributes.glsl
#include ../lib/material.glsl

void main() {
  readRow();
  vec2 rotation = vec2(cos(rollOf(attributes)), sin(rollOf(attributes)));
  puffPoint = vec2(rotation.x * corner.x + rotation.y * corner.y, rotation.x * corner.y - rotation.y * corner.x);
  variation = variationOf(attributes) % textureSize(colorCoverage, 0).z;
  material = materialOf(attributes, ramps);
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  gl_Position = clipFromView * vec4(centre + vec3(corner * place.w, 0.0), 1.0);
}
