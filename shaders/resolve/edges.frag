precision highp float;

// Smooths edges between flat tones in screen space, after Reshetnikov, 'Morphological Antialiasing' (2009). Where two
// tones meet along a nearly straight line, each pixel next to the line is blended with the other tone by the area that
// the line covers between its two ends. Flat pixels stay bit-exact, and corners stay sharp. Drawn over the tiles that
// contain an edge.
// GPUs run pixels in groups, and a group takes each branch that one of its pixels takes: a branch saves little, but a
// loop that ends early does. Code for several directions is therefore written once, in a loop over them.
// Input: chosen tones of tones.frag. Output: premultiplied display-encoded colour.
out vec4 pixel;

#include ../lib/srgb.glsl
#include ../lib/tones.glsl

const int LONGEST = 12;

float difference(vec4 a, vec4 b) {
  vec4 gap = abs(a - b);
  return max(max(gap.r, gap.g), max(gap.b, gap.a));
}

bool alike(vec4 a, vec4 b) {
  return difference(a, b) <= EDGE;
}

// Follows an edge until the tone on either side of it changes. x: number of steps. y: 1 if the edge bends into our own
// row there and continues, as a slanted line does; 0 at a corner or at a third tone.
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

// Area of a pixel under the line that falls from 1/2, at a bend `steps` pixels ahead, to 0 in the middle of the span.
float areaAt(vec2 bend, float span) {
  float from = bend.x - 1.0;
  float reach = clamp(0.5 * span - from, 0.0, 1.0);
  return bend.y * reach * (0.5 - (from + 0.5 * reach) / span);
}

// Share of the pixel on the other side of its edge towards `across`.
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

// Share of the other tone beside a staircase of one-pixel steps, whose line can be on either side: see `besideStair`.
const float BESIDE_STAIR = 1.0 / 32.0;

// Whether the tone continues as a staircase on both sides of a corner and behind it. A line two pixels wide would get
// darker.
bool isWideStair(ivec2 at, ivec2 corner, vec4 tone) {
  for (int tap = 0; tap < 4; ++tap) {
    ivec2 steps = tap < 2 ? ivec2(2 * tap, 2 - 2 * tap) : ivec2(tap);
    if (!alike(toneAt(at + steps * corner), tone)) return false;
  }
  return true;
}

// Blends a pixel that touches such a staircase only at a corner. Without this, a 45-degree edge has one intermediate
// tone on each side.
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

// Counts the eight neighbours with the tone `own`, and returns one of them in `one`.
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

// Whether a pixel is isolated or has one similar neighbour only. Thinning lines and patches of light leave such specks,
// which a drawing by hand does not have.
bool isSpeck(ivec2 at, vec4 own) {
  // For a pair, test the other pixel as well.
  for (int asked = 0; asked < 2; ++asked) {
    ivec2 other;
    int count = likeAround(at, own, other);
    if (count == 0) return true;
    if (count > 1) return false;
    at = other;
  }
  return true;
}

// Blends a pixel on an edge with the tone on the other side. `gaps` are the differences from the tones to the north,
// south, east and west.
vec4 smoothed(ivec2 at, vec4 own, mat4 around, vec4 gaps) {
  vec2 widest = vec2(max(gaps.x, gaps.y), max(gaps.z, gaps.w));
  ivec2 towards = ivec2(gaps.z >= gaps.w ? 1 : -1, gaps.x >= gaps.y ? 1 : -1);
  vec4 above = towards.y > 0 ? around[0] : around[1];
  // The step of a staircase belongs to two edges; the longer one gives the slope.
  bool level = widest.y <= EDGE;
  if (min(widest.x, widest.y) > EDGE) {
    level = min(gaps.z, gaps.w) <= EDGE && alike(toneAt(at + ivec2(-towards.x, towards.y)), above);
  }
  ivec2 across = level ? ivec2(0, towards.y) : ivec2(towards.x, 0);
  // A line one pixel wide has an edge on both sides and leaves the pixel through one of them.
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

// The neighbouring tone that is most similar to a speck.
vec4 nearest(mat4 around, vec4 gaps) {
  vec4 others = mix(gaps, vec4(2.0), lessThanEqual(gaps, vec4(EDGE)));
  float smallest = min(min(others.x, others.y), min(others.z, others.w));
  return smallest == others.x ? around[0] : smallest == others.y ? around[1] : smallest == others.z ? around[2] : around[3];
}

vec4 resolved(ivec2 at, vec4 own) {
  mat4 around = mat4(
    toneAt(at + ivec2(0, 1)), toneAt(at - ivec2(0, 1)), toneAt(at + ivec2(1, 0)), toneAt(at - ivec2(1, 0))
  );
  vec4 gaps = vec4(
    difference(own, around[0]), difference(own, around[1]), difference(own, around[2]), difference(own, around[3])
  );
  bvec4 isLike = lessThanEqual(gaps, vec4(EDGE));
  if (all(isLike)) return besideStair(at, own);
  // Cheap test first: most edge pixels have at least two similar sides, which no speck has.
  if (dot(vec4(isLike), vec4(1.0)) < 2.0 && isSpeck(at, own)) return nearest(around, gaps);
  return smoothed(at, own, around, gaps);
}

#ifdef MARKS
vec4 withMarks(vec4 color, ivec2 at);
#endif

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 tone = resolved(at, toneAt(at));
  pixel = vec4(tone.rgb * tone.a, tone.a);
#ifdef MARKS
  pixel = withMarks(pixel, at);
#endif
}
