precision highp float;

// Smooths the edges: where two flat tones meet along a nearly straight line, each pixel beside the line takes as much of
// the other tone as the line, seen between its two ends, would cover. Flat pixels pass through untouched, bit for bit,
// and corners stay sharp. After the idea of Reshetnikov, 'Morphological Antialiasing' (2009).
// Where pixels are drawn in groups, and all of a group goes wherever one of it goes, a branch saves nothing but a loop
// that ends does: what is the same for several directions stands here once, in a loop over them.
uniform sampler2D tones;

out vec4 pixel;

#include ../lib/srgb.glsl

// Half a step of an 8-bit channel would be noise; anything an eye sees as an edge is far above this.
const float EDGE = 0.04;
const int LONGEST = 12;

vec4 toneAt(ivec2 at) {
  return texelFetch(tones, clamp(at, ivec2(0), textureSize(tones, 0) - 1), 0);
}

float difference(vec4 a, vec4 b) {
  vec4 gap = abs(a - b);
  return max(max(gap.r, gap.g), max(gap.b, gap.a));
}

bool alike(vec4 a, vec4 b) {
  return difference(a, b) <= EDGE;
}

// Walks along an edge until either side of it changes. x: steps taken, y: 1 if the edge turned into our own row there
// to go on, as a slanted line does; not where it ended in a corner or met another tone.
vec2 walk(ivec2 at, ivec2 along, ivec2 across, vec4 own, vec4 other) {
  for (int i = 1; i <= LONGEST; ++i) {
    vec4 ownHere = toneAt(at + i * along);
    vec4 otherHere = toneAt(at + i * along + across);
    if (!alike(ownHere, own)) {
      bool goesOn = alike(otherHere, own) || alike(toneAt(at + i * along - across), own);
      return vec2(i, alike(ownHere, other) && goesOn ? 1.0 : 0.0);
    }
    if (!alike(otherHere, other)) return vec2(i, 0.0);
  }
  return vec2(LONGEST + 1, 0.0);
}

// Area of a pixel under the line that falls from a half, at a bend `steps` pixels ahead, to nothing in the middle.
float areaAt(vec2 bend, float span) {
  float from = bend.x - 1.0;
  float reach = clamp(0.5 * span - from, 0.0, 1.0);
  return bend.y * reach * (0.5 - (from + 0.5 * reach) / span);
}

// How much of this pixel lies on the other side of its edge towards `across`.
float shareOf(ivec2 at, ivec2 across, vec4 own, vec4 other) {
  vec4 bends = vec4(0.0);
  for (int way = -1; way <= 1; way += 2) {
    bends = vec4(bends.zw, walk(at, way * across.yx, across, own, other));
  }
  float span = bends.x + bends.z - 1.0;
  return areaAt(bends.xy, span) + areaAt(bends.zw, span);
}

vec4 blend(vec4 own, vec4 other, float share) {
  float alpha = mix(own.a, other.a, share);
  vec3 light = mix(linearFromDisplay(own.rgb) * own.a, linearFromDisplay(other.rgb) * other.a, share);
  return vec4(displayFromLinear(alpha > 0.0 ? light / alpha : light), alpha);
}

// The next tone of a stair whose steps are one pixel each, from which the line can lie either way: see `besideStair`.
const float BESIDE_STAIR = 1.0 / 32.0;

// Whether the tone goes on as a stair on both sides of a corner, and behind it: a line of two pixels would grow darker.
bool isWideStair(ivec2 at, ivec2 corner, vec4 tone) {
  for (int tap = 0; tap < 4; ++tap) {
    ivec2 steps = tap < 2 ? ivec2(2 * tap, 2 - 2 * tap) : ivec2(tap);
    if (!alike(toneAt(at + steps * corner), tone)) return false;
  }
  return true;
}

// A pixel that touches such a stair with a corner alone. Without it an edge of 45 degrees had one tone on each side.
vec4 besideStair(ivec2 at, vec4 own) {
  vec4 gap = max(
    max(abs(toneAt(at + ivec2(-1, -1)) - own), abs(toneAt(at + ivec2(1, -1)) - own)),
    max(abs(toneAt(at + ivec2(-1, 1)) - own), abs(toneAt(at + ivec2(1, 1)) - own))
  );
  bool isFlat = all(lessThanEqual(gap, vec4(EDGE)));
  for (int corner = isFlat ? 4 : 0; corner < 4; ++corner) {
    ivec2 towards = ivec2(2 * (corner & 1), corner & 2) - 1;
    vec4 other = toneAt(at + towards);
    if (!alike(other, own) && isWideStair(at, towards, other)) return blend(own, other, BESIDE_STAIR);
  }
  return own;
}

// Neighbours over sides and corners with the tone `own`, and one of them.
int likeAround(ivec2 at, vec4 own, out ivec2 one) {
  int count = 0;
  one = at;
  for (int place = 0; place < 9; ++place) {
    ivec2 there = at + ivec2(place % 3, place / 3) - 1;
    if (place == 4 || !alike(toneAt(there), own)) continue;
    one = there;
    ++count;
  }
  return count;
}

// Whether a pixel stands alone or with a single other one, as nothing does that a hand has drawn: where a line or a
// patch of light thins out, pixels catch it here and there.
bool isSpeck(ivec2 at, vec4 own) {
  // With one like it, that one is asked in its turn.
  for (int asked = 0; asked < 2; ++asked) {
    ivec2 other;
    int count = likeAround(at, own, other);
    if (count == 0) return true;
    if (count > 1) return false;
    at = other;
  }
  return true;
}

// What of the other tones lies over a pixel beside an edge. @param gaps to the tones in the north, south, east and west
vec4 smoothed(ivec2 at, vec4 own, mat4 around, vec4 gaps) {
  vec2 widest = vec2(max(gaps.x, gaps.y), max(gaps.z, gaps.w));
  ivec2 towards = ivec2(gaps.z >= gaps.w ? 1 : -1, gaps.x >= gaps.y ? 1 : -1);
  vec4 above = towards.y > 0 ? around[0] : around[1];
  // A step of a stair is seen from both of its edges: the longer one tells the slope.
  bool level = widest.y <= EDGE;
  if (min(widest.x, widest.y) > EDGE) {
    level = min(gaps.z, gaps.w) <= EDGE && alike(toneAt(at + ivec2(-towards.x, towards.y)), above);
  }
  ivec2 across = level ? ivec2(0, towards.y) : ivec2(towards.x, 0);
  // A line as thin as a pixel has an edge on either side, and leaves the pixel through one of them.
  bool isThin = min(level ? gaps.x : gaps.z, level ? gaps.y : gaps.w) > EDGE;
  vec4 taken = own;
  ivec2 from = at;
  float share = 0.0;
  for (int side = 0; side < (isThin ? 2 : 1); ++side) {
    vec4 other = toneAt(at + across);
    float found = shareOf(at, across, own, other);
    if (found > share) {
      taken = other;
      from = at + across;
      share = found;
    }
    across = -across;
  }
  return share > 0.0 && !isSpeck(from, taken) ? blend(own, taken, share) : own;
}

// The tone beside a speck that is most like it.
vec4 nearest(mat4 around, vec4 gaps) {
  vec4 others = mix(gaps, vec4(2.0), lessThanEqual(gaps, vec4(EDGE)));
  float smallest = min(min(others.x, others.y), min(others.z, others.w));
  return smallest == others.x ? around[0] : smallest == others.y ? around[1] : smallest == others.z ? around[2] : around[3];
}

// A pixel as it is where nothing meets; else what lies over it.
vec4 resolved(ivec2 at, vec4 own) {
  mat4 around = mat4(
    toneAt(at + ivec2(0, 1)), toneAt(at - ivec2(0, 1)), toneAt(at + ivec2(1, 0)), toneAt(at - ivec2(1, 0))
  );
  vec4 gaps = vec4(
    difference(own, around[0]), difference(own, around[1]), difference(own, around[2]), difference(own, around[3])
  );
  bvec4 isLike = lessThanEqual(gaps, vec4(EDGE));
  if (all(isLike)) return besideStair(at, own);
  // Most of what has edges has two sides alike, which no speck has.
  if (dot(vec4(isLike), vec4(1.0)) < 2.0 && isSpeck(at, own)) return nearest(around, gaps);
  return smoothed(at, own, around, gaps);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 tone = resolved(at, toneAt(at));
  pixel = vec4(tone.rgb * tone.a, tone.a);
}
