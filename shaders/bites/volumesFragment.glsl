// Inserted into volumes/volumes.frag. 13: declarations. Outputs of volumeVertex.glsl.
flat in vec3 firstBiteSeen;
flat in vec3 sideBiteSeen;
flat in float erosionAndWidth;

#include place.glsl
#include cut.glsl

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

vec2 biteAlongRay(vec3 centre, float radius, vec2 point) {
  float nearness = 1.0 / (1.0 + eyeAndGrowth.w * centre.z);
  return alongRay(centre.xy * nearness, centre.z, radius * radius * nearness * nearness, point);
}

void meetBites(vec2 point) {
  vec3 radii = 2.0 * fract(erosionAndWidth) * biteRadii(floor(erosionAndWidth) / 255.0);
  vec2 one = biteAlongRay(firstBiteSeen, radii.x, point);
  vec2 other = biteAlongRay(-firstBiteSeen, radii.y, point);
  vec2 side = biteAlongRay(sideBiteSeen, radii.z, point);
  vec2 high = one.x > other.x ? one : other;
  vec2 low = one.x > other.x ? other : one;
  vec2 second = side.x > high.x ? high : side.x > low.x ? side : low;
  vec2 first = biteOf(max(high.x, side.x), side.x > high.x ? side.y : high.y);
  vec2 third = biteOf(min(low.x, side.x), side.x < low.x ? side.y : low.y);
  second = biteOf(second.x, second.y);
  bitesEnd = vec3(first.x, second.x, third.x);
  bitesStart = vec3(first.y, second.y, third.y);
}

// Whether a light ray meets what is left of a lobe. A disc is the section of a tangent cone, wider than its lobe.
bool isLeft(vec4 disc, vec2 point) {
  float growth = eyeAndGrowth.w;
  vec2 part = alongRay(disc.xy, disc.w, disc.z / (1.0 + growth * growth * disc.z), point);
  float halfExtent = sqrt(max(part.y, 0.0));
  return part.y > 0.0 && uncut(part.x + halfExtent) > part.x - halfExtent;
}
#pragma section
  // 14: in the volume.
  meetBites(point);
  bool isShaded = false;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    isShaded = isShaded || isLeft(discs[ i ], point);
  }
  #pragma unroll_loop_end
  if (!isShaded) discard;
