precision highp float;
precision highp int;

// A soft quad that faces the camera, as particle libraries draw smoke. Rows are in world space, `puffPoint` is in
// radii.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform sampler2D ramps;

out vec2 puffPoint;
flat out vec3 depthRadiusFade;
flat out float material;

#include ../lib/rows.glsl
#include ../lib/attributes.glsl
#include ../lib/material.glsl

void main() {
  readRow();
  puffPoint = corner;
  material = materialOf(attributes, ramps);
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  depthRadiusFade = vec3(-centre.z, place.w, 1.0 - ageOf(attributes));
  vec4 clip = clipFromView * vec4(centre + vec3(corner * place.w, 0.0), 1.0);
  gl_Position = vec4(clip.xy, 0.0, clip.w);
}
