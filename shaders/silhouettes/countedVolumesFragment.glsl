// Added to countedVolumes/countedVolumes.frag.
#include picture.glsl

uniform float pad;
uniform float distanceRange;

// Least step along a line, in radii, which is about half a texel; and number of steps, enough for any line.
const float LEAST_STEP = 0.01;
const int STEPS = 220;

// The place at which a line enters the silhouette, from `start` on, or `end` if it does not. Steps are as long as the distance to
// the silhouette (Hart, 'Sphere tracing', 1996).
float entry(vec2 origin, vec2 direction, float start, float end) {
  float at = start;
  float way = sign(end - start);
  float before = 0.0;
  float stepped = 0.0;
  for (int i = 0; i < STEPS; i++) {
    float outside = (alphaAt(origin + at * direction) - 0.5) * distanceRange;
    if (outside < 0.0) return at - way * stepped * outside / min(outside - before, -1e-6);
    before = outside;
    stepped = max(outside, LEAST_STEP);
    at += way * stepped;
    if (way * (end - at) < 0.0) break;
  }
  return end;
}

// Shortens the interval along a line, with a direction and a signed distance from the origin, to that between its first entry into
// the silhouette and its last exit. Returns false if the line misses the silhouette.
bool crossSilhouette(inout vec2 stretch, vec2 direction, float offset) {
  vec2 origin = offset * vec2(-direction.y, direction.x);
  float first = entry(origin, direction, stretch.x, stretch.y);
  if (first == stretch.y) return false;
  stretch = vec2(first, entry(origin, direction, stretch.y, stretch.x));
  return true;
}
