precision highp float;

// Writes the depth at which a light ray hits the first lobe of a puff, in the light's view space.
uniform mat4 clipFromView;
uniform vec2 viewport;

flat in vec4 lobes[LOBES];
#ifdef DEFORMED
flat in mat3 unstretching;
#endif

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

#include ../lib/depth.glsl
#include ../lib/pixel.glsl

const float NOWHERE = 1e8;

// Distance along a ray at which it enters a lobe.
float meet(vec3 origin, vec3 way, vec4 lobe) {
  vec3 offset = lobe.xyz - origin;
  float along = dot(offset, way);
  vec3 beside = offset - along * way;
  float squared = lobe.w * lobe.w - dot(beside, beside);
  return squared > 0.0 ? along - sqrt(squared) : NOWHERE;
}

void main() {
  bool isLamp = clipFromView[2][3] != 0.0;
  vec3 seen = vec3(viewPointOf(gl_FragCoord.xy, clipFromView, viewport, -1.0), -1.0);
  vec3 origin = isLamp ? vec3(0.0) : seen;
  vec3 way = isLamp ? normalize(seen) : vec3(0.0, 0.0, -1.0);
  float wayZ = way.z;
  vec3 start = origin;
#ifdef DEFORMED
  start = unstretching * origin;
  way = unstretching * way;
  float pace = length(way);
  way /= pace;
  wayZ /= pace;
#endif
  float nearest = NOWHERE;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    nearest = min(nearest, meet(start, way, lobes[ i ]));
  }
  #pragma unroll_loop_end
  if (nearest == NOWHERE) discard;
  unlit = vec4(0.0);
  lit = vec4(0.0);
  gl_FragDepth = windowDepth(clipFromView, origin.z + nearest * wayZ);
}
