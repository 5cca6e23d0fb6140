// The bites of a puff that casts shadow. The code is inserted into volumes.frag, see src/smoke/bites.ts.
#include ../lib/bites.glsl

// The part of a light ray in a ball: its middle along the light, and the square of half of its length. The ball is given by its
// centre as seen on the plane of the discs, its place along the light, and the square of its radius on that plane.
vec2 alongRay(vec2 seen, float place, float squared, vec2 point) {
  float growth = eyeAndGrowth.w;
  float scale = 1.0 + growth * place;
  vec2 offset = (point - seen) * scale;
  float slant = 1.0 + growth * growth * dot(point, point);
  float middle = -growth * dot(point, offset) / slant;
  return vec2(place + middle, middle * middle - (dot(offset, offset) - squared * scale * scale) / slant);
}

vec2 biteAlongRay(vec4 bite, vec2 point) {
  float nearness = 1.0 / (1.0 + eyeAndGrowth.w * bite.z);
  float radius = max(bite.w, 0.0) * nearness;
  return alongRay(bite.xy * nearness, bite.z, radius * radius, point);
}

// A disc is the section of a tangent cone, wider than its lobe.
vec2 lobeAlongRay(vec4 disc, vec2 point) {
  return alongRay(disc.xy, disc.w, disc.z / (1.0 + eyeAndGrowth.w * eyeAndGrowth.w * disc.z), point);
}

void meetLobe(vec2 part) {
  meetLobe(part.x, part.y);
}

// Whether the light ray meets a part of a lobe that is left.
bool isShaded(vec2 point, float erosion, float across) {
  placeBites(erosion, biteAxisAndErosion.xyz, biteSideAndSqueeze.xyz);
  mat3x2 parts;
  for (int i = 0; i < 3; i++) {
    parts[ i ] = biteAlongRay(vec4(bites[ i ].xyz, across * bites[ i ].w), point);
  }
  biteMiddles = vec3(parts[ 0 ].x, parts[ 1 ].x, parts[ 2 ].x);
  meetBites(vec3(parts[ 0 ].y, parts[ 1 ].y, parts[ 2 ].y));
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    meetLobe(lobeAlongRay(discs[ i ], point));
  }
  #pragma unroll_loop_end
  return remaining().height > NOTHING;
}
