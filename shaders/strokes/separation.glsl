// Separation of a lobe from the smoke behind it at a place on its arc, 0..1, by the depth of the picture on both sides of the
// outline. Several distances are sampled, so that it changes gradually as other smoke moves past. Needs arc.glsl.
uniform float innerLine;
uniform float innerTaper;
uniform sampler2D lit;

#include ../lib/depth.glsl
#include ../lib/mask.glsl
#include smokeDepth.glsl

// Depth between a lobe and what is behind it, in radii of the lobe, at which a stroke begins and is complete.
const vec2 GAPS = vec2(0.0, 0.16);
// Height of other smoke before the lobe, in its radii, at which a stroke ends and vanishes.
const vec2 COVERS = vec2(0.0, 0.1);
// Distances of the samples from the outline, CSS pixels, and their rounding to pixel centres, pixels.
const vec2 BESIDE = vec2(1.75, 5.0);
const float ROUNDING = 0.75;
const int TAPS = 9;

// Whether a point is outside all lobes of the puff.
bool isOutside(vec2 point) {
  int variation = variationOf(attributes) % textureSize(lobeTable, 0).y;
  mat3 viewFromPuff = mat3(viewFromWorld) * worldFromPuff(attributes);
  for (int i = 0; i < textureSize(lobeTable, 0).x - 1; i++) {
    vec4 other = texelFetch(lobeTable, ivec2(i, variation), 0);
#ifdef DEFORMED
    other.xyz *= unfolded(i, ageOf(attributes));
#endif
    other.xyz = viewFromPuff * other.xyz;
#ifdef DEFORMED
    other.xyz = unstretched(projection, other.xyz / acrossOf(stretchOf(attributes.w).w));
#endif
    if (length(point - other.xy) < other.w) return false;
  }
  return true;
}

// Whether a pixel shows the line around the puff, `gap` radii behind the outline. That line has a depth of its own.
bool isOwnLine(float gap, vec2 at, vec2 point) {
  const float SLACK = 0.05;
  if (gap < innerLine * (1.0 - SLACK) || gap > innerLine * (1.0 + innerTaper) * (1.0 + SLACK)) return false;
  ivec2 texel = clamp(ivec2(floor(at)), ivec2(0), textureSize(lit, 0) - 1);
  return isInk(texelFetch(lit, texel, 0).a) && isOutside(point);
}

// The mean of some of the taps about a place on the arc: each with this stride.
float separationAt(float along, int stride) {
  float size = lobe.w * radius;
  float sum = 0.0;
  for (int i = 0; i < TAPS; i += stride) {
    float there = along + (float(i) + 0.5 - 0.5 * float(TAPS)) / float(TAPS) * 2.0 / float(LAST);
    vec2 place = placeAt(there);
    vec2 normal = viewNormal(outwardAt(there));
    float z = outlineZAt(there);
    float distance = mix(BESIDE.x, BESIDE.y, float(i) / float(TAPS - 1)) * pixelRatio * pixel;
    vec2 beside = place + normal * distance;
    vec2 at = pixelAt(beside);
    float outside = smokeZ(clipFromView, at);
    float gap = z - outside;
    if (outside < NO_SMOKE || gap <= GAPS.x * size) continue;
    if (isOwnLine(gap / radius, at, unviewPoint(beside / radius))) continue;
    float inside = smokeZ(clipFromView, pixelAt(place - normal * distance));
    if (inside < z - GAPS.y * size) continue;
    float reach = min(1.0, (distance + ROUNDING * pixel) / size);
    float top = z + height * sqrt(reach * (2.0 - reach));
    float before = smoothstep(GAPS.x, GAPS.y, gap / size);
    sum += before * (1.0 - smoothstep(COVERS.x, COVERS.y, (inside - top) / size));
  }
  return sum / float(TAPS);
}
