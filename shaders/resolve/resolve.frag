precision highp float;

// Chooses between lit and unlit by the mask and smooths the edges: where two flat tones meet along a nearly straight
// line, each pixel beside the line takes as much of the other tone as the line, seen between its two ends, would cover.
// Flat pixels pass through untouched, bit for bit, and corners stay sharp. After the idea of Reshetnikov,
// 'Morphological Antialiasing' (2009).
uniform sampler2D unlit;
uniform sampler2D lit;
uniform vec3 deepShadow;
uniform bool smoothEdges;
// Takes all that is not ink to be in deep shadow, whatever the mask says.
uniform bool isAllDeep;

out vec4 pixel;

#include ../lib/srgb.glsl

// Half a step of an 8-bit channel would be noise; anything an eye sees as an edge is far above this.
const float EDGE = 0.04;
const int LONGEST = 12;
// Around 3/4, which the mask says of deep shadow; 1/2 or 1 is plain shadow.
const vec2 DEEP = vec2(0.625, 0.875);

vec4 toneAt(ivec2 at) {
  ivec2 inside = clamp(at, ivec2(0), textureSize(lit, 0) - 1);
  vec4 shadowed = texelFetch(unlit, inside, 0);
  vec4 direct = texelFetch(lit, inside, 0);
  // Ink holds 1 from the start, and is the same in every light.
  bool isDeep = isAllDeep ? direct.a < DEEP.y : direct.a > DEEP.x && direct.a < DEEP.y;
  if (isDeep) shadowed.rgb *= deepShadow;
  return vec4(isAllDeep || direct.a > 0.25 ? shadowed.rgb : direct.rgb, shadowed.a);
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

// Area of a pixel under the line that falls from a half, at a turn `steps` pixels ahead, to nothing in the middle.
float areaAt(vec2 turn, float span) {
  float from = turn.x - 1.0;
  float reach = clamp(0.5 * span - from, 0.0, 1.0);
  return turn.y * reach * (0.5 - (from + 0.5 * reach) / span);
}

// How much of this pixel lies on the other side of its edge towards `across`.
float shareOf(ivec2 at, ivec2 across, vec4 own, vec4 other) {
  ivec2 along = across.yx;
  vec2 ahead = walk(at, along, across, own, other);
  vec2 behind = walk(at, -along, across, own, other);
  float span = ahead.x + behind.x - 1.0;
  return areaAt(ahead, span) + areaAt(behind, span);
}

vec4 blend(vec4 own, vec4 other, float share) {
  float alpha = mix(own.a, other.a, share);
  vec3 light = mix(linearFromDisplay(own.rgb) * own.a, linearFromDisplay(other.rgb) * other.a, share);
  return vec4(displayFromLinear(alpha > 0.0 ? light / alpha : light), alpha);
}

// The next tone of a stair whose steps are one pixel each, from which the line can lie either way: see `besideStair`.
const float BESIDE_STAIR = 1.0 / 32.0;

// A pixel that touches such a stair with a corner alone. Without it an edge of 45 degrees had one tone on each side.
vec4 besideStair(ivec2 at, vec4 own) {
  vec4 direct = texelFetch(lit, at, 0);
  ivec2 last = textureSize(lit, 0) - 1;
  for (int corner = 0; corner < 4; ++corner) {
    ivec2 towards = ivec2(2 * (corner & 1), corner & 2) - 1;
    if (alike(texelFetch(lit, clamp(at + towards, ivec2(0), last), 0), direct)) continue;
    vec4 other = toneAt(at + towards);
    bool isStair = alike(toneAt(at + ivec2(2 * towards.x, 0)), other) && alike(toneAt(at + ivec2(0, 2 * towards.y)), other);
    // A line of two pixels would grow darker.
    bool isWide = alike(toneAt(at + 2 * towards), other) && alike(toneAt(at + 3 * towards), other);
    if (isStair && isWide && !alike(other, own)) return blend(own, other, BESIDE_STAIR);
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
  ivec2 other, back;
  int count = likeAround(at, own, other);
  return count == 0 || (count == 1 && likeAround(other, own, back) == 1);
}

// Whether nothing meets here: most of a picture, told by one texture alone. What differs without light only, such as black
// smoke without ink on a transparent page, counts as flat too.
bool isFlat(ivec2 at) {
  // Beyond the border comes anything; a pixel there is not flat, and looked at closely.
  vec4 one = texelFetch(lit, at, 0);
  vec4 two = texelFetchOffset(lit, at, 0, ivec2(1, 0));
  vec4 three = texelFetchOffset(lit, at, 0, ivec2(-1, 0));
  vec4 four = texelFetchOffset(lit, at, 0, ivec2(0, 1));
  vec4 five = texelFetchOffset(lit, at, 0, ivec2(0, -1));
  vec4 six = texelFetchOffset(lit, at, 0, ivec2(1, 1));
  vec4 seven = texelFetchOffset(lit, at, 0, ivec2(-1, 1));
  vec4 eight = texelFetchOffset(lit, at, 0, ivec2(1, -1));
  vec4 nine = texelFetchOffset(lit, at, 0, ivec2(-1, -1));
  vec4 least = min(min(min(one, two), min(three, four)), min(min(five, six), min(seven, min(eight, nine))));
  vec4 most = max(max(max(one, two), max(three, four)), max(max(five, six), max(seven, max(eight, nine))));
  return alike(least, most);
}

vec4 smoothed(ivec2 at, vec4 own) {
  vec4 north = toneAt(at + ivec2(0, 1));
  vec4 south = toneAt(at - ivec2(0, 1));
  vec4 east = toneAt(at + ivec2(1, 0));
  vec4 west = toneAt(at - ivec2(1, 0));
  vec4 gaps = vec4(difference(own, north), difference(own, south), difference(own, east), difference(own, west));
  vec2 widest = vec2(max(gaps.x, gaps.y), max(gaps.z, gaps.w));
  if (max(widest.x, widest.y) <= EDGE) return besideStair(at, own);
  // Most of what has edges has two sides alike, which no speck has.
  if (dot(vec4(lessThanEqual(gaps, vec4(EDGE))), vec4(1.0)) < 2.0 && isSpeck(at, own)) {
    vec4 others = mix(gaps, vec4(2.0), lessThanEqual(gaps, vec4(EDGE)));
    float least = min(min(others.x, others.y), min(others.z, others.w));
    return least == others.x ? north : least == others.y ? south : least == others.z ? east : west;
  }
  ivec2 towards = ivec2(gaps.z >= gaps.w ? 1 : -1, gaps.x >= gaps.y ? 1 : -1);
  vec4 above = towards.y > 0 ? north : south;
  vec4 beside = towards.x > 0 ? east : west;
  // A step of a stair is seen from both of its edges: the longer one tells the slope.
  bool level = widest.y <= EDGE;
  if (min(widest.x, widest.y) > EDGE) {
    level = min(gaps.z, gaps.w) <= EDGE && alike(toneAt(at + ivec2(-towards.x, towards.y)), above);
  }
  ivec2 across = level ? ivec2(0, towards.y) : ivec2(towards.x, 0);
  vec4 taken = level ? above : beside;
  float share = shareOf(at, across, own, taken);
  ivec2 from = at + across;
  // A line as thin as a pixel has an edge on either side, and leaves the pixel through one of them.
  if (min(level ? gaps.x : gaps.z, level ? gaps.y : gaps.w) > EDGE) {
    vec4 opposite = toneAt(at - across);
    float oppositeShare = shareOf(at, -across, own, opposite);
    if (oppositeShare > share) {
      taken = opposite;
      from = at - across;
    }
    share = max(share, oppositeShare);
  }
  return share > 0.0 && !isSpeck(from, taken) ? blend(own, taken, share) : own;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 tone = toneAt(at);
  if (smoothEdges && !isFlat(at)) tone = smoothed(at, tone);
  pixel = vec4(tone.rgb * tone.a, tone.a);
}
