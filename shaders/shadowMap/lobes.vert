precision highp float;
precision highp int;

// A puff in the depth map of the light: a quad through its centre that faces the light and contains all of its lobes.
// Outputs the lobes in the light's view space, metres.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform float reach;
// See bodies/lobes.vert.
uniform sampler2D lobeTable;

flat out vec4 lobes[LOBES];
#ifdef DEFORMED
// From view space to the space of the lobes, where they are balls.
flat out mat3 unstretching;
#endif

#include ../lib/rows.glsl
#include ../lib/attributes.glsl
#include ../lib/orientation.glsl

void main() {
  readRow();
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  mat3 viewFromPuff = place.w * mat3(viewFromWorld) * worldFromPuff(attributes);
#ifdef DEFORMED
  vec4 stretch = stretchOf(attributes.w);
  vec3 axis = mat3(viewFromWorld) * stretch.xyz;
  vec3 along = (1.0 / stretch.w - 1.0) * axis;
  unstretching = mat3(1.0) + mat3(along * axis.x, along * axis.y, along * axis.z);
  float across = acrossOf(stretch.w);
#endif
  int variation = variationOf(attributes) % textureSize(lobeTable, 0).y;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    lobes[ i ] = texelFetch(lobeTable, ivec2(UNROLLED_LOOP_INDEX, variation), 0);
#ifdef DEFORMED
    lobes[ i ].xyz *= unfolded(UNROLLED_LOOP_INDEX, casterAgeOf(attributes));
#endif
    lobes[ i ] = vec4(centre + viewFromPuff * lobes[ i ].xyz, place.w * lobes[ i ].w);
#ifdef DEFORMED
    lobes[ i ] = vec4(unstretching * lobes[ i ].xyz, across * lobes[ i ].w);
#endif
  }
  #pragma unroll_loop_end

  bool isLamp = clipFromView[2][3] != 0.0;
  float radius = reach * place.w;
  // Squared ratio of the puff's radius to its distance. A puff that contains the lamp casts no shadow.
  float nearness = isLamp ? radius * radius / dot(centre, centre) : 0.0;
  vec3 away = isLamp ? normalize(centre) : vec3(0.0, 0.0, -1.0);
  vec3 side = normalize(cross(away, abs(away.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0)));
  vec2 point = corner * radius * inversesqrt(max(1.0 - nearness, 1e-4));
  vec4 clip = clipFromView * vec4(centre + point.x * side + point.y * cross(side, away), 1.0);
  // Fragments write the depth. A constant here keeps the near plane from clipping the quad.
  gl_Position = nearness < 1.0 ? vec4(clip.xy, 0.0, clip.w) : vec4(0.0, 0.0, 2.0, 1.0);
}
