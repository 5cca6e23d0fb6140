precision highp float;
precision highp int;

// The share of each pixel that marks cover, on one of what a picture shows. ON_SMOKE: places are those of place.glsl. ON_SURFACES:
// places are in world space, also with ON_HOST on the objects of a host's scene, over which the marks are blended. Otherwise
// places on the backdrop are the direction of view.
// DOTS, LINES, CROSSHATCH or GRAIN; without these, the amount itself. SHIFTED: marks are beside what they are on.
uniform sampler2D places;
// Of amount.glsl. A dot has the amount of its centre.
uniform sampler2D amounts;
uniform highp sampler2D depth;
uniform mat4 clipFromView;
uniform mat4 viewFromWorld;
uniform vec2 viewport;
uniform float patternCoverage;
uniform float patternBackdrop;
// Cosine and sine of the angle of the pattern.
uniform vec2 tilt;
// By which dots roll over puffs with the camera, in radii.
uniform vec2 rolled;
// Roll of a full turn of the camera at angle 0, in radii.
uniform float fullTurn;
// Of marks in the picture, pixels.
uniform ivec2 shift;
#ifdef ON_HOST
uniform vec2 viewportOrigin;
uniform vec3 patternColor;
uniform bool isLinear;
#include ../lib/srgb.glsl
#endif

layout(location = 0) out vec4 covered;

#include ../lib/depth.glsl
#include ../lib/pixel.glsl
#include ../lib/shading.glsl
#include place.glsl
#include lattice.glsl

// What a pixel holds.
struct Spot {
  float amount;
  float ink;
  // Whether it shows what the marks are on.
  bool isHere;
  // Of the puff, metres.
  float radius;
};

// A place, and its changes for a pixel to the right and for one up.
struct Placed {
#if defined(ON_SMOKE) && !defined(FLAT_PLACE)
  vec3 place;
  mat2x3 gradient;
#else
  vec2 place;
  mat2 gradient;
#endif
};

ivec2 inPicture(ivec2 at) {
  return clamp(at, ivec2(0), textureSize(depth, 0) - 1);
}

Spot spotAt(ivec2 at) {
#if defined(ON_HOST)
  return Spot(patternCoverage, 0.0, true, 0.0);
#else
  vec4 texel = texelFetch(amounts, at, 0);
  float radius = radiusOf(texel.a);
#if defined(ON_SMOKE)
  bool isHere = texel.a > 0.0;
#elif defined(ON_SURFACES)
  bool isHere = texel.b > 0.5;
#else
  bool isHere = texel.a + texel.b == 0.0;
#endif
  return Spot(texel.r, texel.g, isHere, radius);
#endif
}

vec2 turned(vec2 place) {
  return vec2(dot(place, tilt), dot(place, vec2(-tilt.y, tilt.x)));
}

// Changes of a place for a pixel of its size.
mat2 turning() {
  return mat2(tilt.x, -tilt.y, tilt.y, tilt.x);
}

#if defined(ON_SMOKE) && defined(FLAT_PLACE)
vec2 placeAt(ivec2 at) {
  return turned(unpackPlace(texelFetch(places, at, 0)).xy) + rolled;
}

// All pixels of a puff at one depth have one size.
Placed placedAt(ivec2 at, Spot own) {
  float z = viewZOf(clipFromView, texelFetch(depth, at, 0).r);
  float perPixel = viewUnitsPerPixel(clipFromView, viewport, z) / own.radius;
  return Placed(placeAt(at), perPixel * turning());
}

vec2 placeThere(ivec2 at) {
  return placeAt(at);
}
#elif defined(ON_SMOKE) || defined(ON_SURFACES)
// On smoke a direction.
vec3 placeAt(ivec2 at) {
#ifdef ON_SMOKE
  return unpackPlace(texelFetch(places, at, 0)) * mat3(viewFromWorld);
#else
  float z = viewZOf(clipFromView, texelFetch(depth, at, 0).r);
  vec3 place = vec3(viewPointOf(vec2(at) + 0.5, clipFromView, viewport, z), z);
  return (place - viewFromWorld[3].xyz) * mat3(viewFromWorld);
#endif
}

// Change of a place to the next pixel, on the side where it is smaller.
vec3 changeOf(vec3 own, ivec2 at, ivec2 way) {
  vec3 back = own - placeAt(inPicture(at - way));
  vec3 forth = placeAt(inPicture(at + way)) - own;
  bool hasBack = at - way == inPicture(at - way);
  bool hasForth = at + way == inPicture(at + way);
  return hasBack && (!hasForth || dot(back, back) < dot(forth, forth)) ? back : forth;
}

mat2x3 changesOf(vec3 place, ivec2 at) {
  return mat2x3(changeOf(place, at, ivec2(1, 0)), changeOf(place, at, ivec2(0, 1)));
}

#ifdef ON_SMOKE
Placed placedAt(ivec2 at, Spot own) {
  vec3 place = placeAt(at);
  return Placed(place, changesOf(place, at));
}
#else
// The axes of the plane that is closest to the surface.
struct Plane {
  vec3 u;
  vec3 v;
} plane;

Plane planeOf(vec3 normal) {
  vec3 a = abs(normal);
  if (a.y > max(a.x, a.z)) return Plane(vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, -1.0));
  if (a.x > a.z) return Plane(vec3(0.0, 0.0, -1.0), vec3(0.0, 1.0, 0.0));
  return Plane(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
}

vec2 onPlane(vec3 place) {
  return turned(vec2(dot(place, plane.u), dot(place, plane.v)));
}

Placed placedAt(ivec2 at, Spot own) {
  vec3 place = placeAt(at);
  mat2x3 changes = changesOf(place, at);
  plane = planeOf(cross(changes[0], changes[1]));
  return Placed(onPlane(place), mat2(onPlane(changes[0]), onPlane(changes[1])));
}

vec2 placeThere(ivec2 at) {
  return onPlane(placeAt(at));
}
#endif
#else
// It turns against the camera.
Placed placedAt(ivec2 at, Spot own) {
  vec2 place = viewPointOf(vec2(at) + 0.5, clipFromView, viewport, -1.0);
  return Placed(turned(place) - rolled, viewUnitsPerPixel(clipFromView, viewport, -1.0) * turning());
}
#endif

#if defined(DOTS)
struct Dot {
  vec2 point;
  // Area on the plane, divided by pi and by the amount.
  float squared;
};

// Length on the plane of a pixel along a way. Only surfaces are seen at an angle.
float pixelAlong(vec2 way, mat2 gradient) {
  float perPixel = length(gradient[0]);
#ifdef ON_SURFACES
  float far = length(way);
  if (far > 0.0) perPixel = length(way * gradient) / far;
#endif
  return max(perPixel, 1e-9);
}

bool isReached(Dot mark, Placed own) {
  vec2 way = mark.point - own.place;
  float perPixel = pixelAlong(way, own.gradient);
  float largest = max(sqrt(mark.squared * max(patternCoverage, patternBackdrop)), 0.5 * perPixel);
  return mark.squared > 0.0 && length(way) < largest + (0.5 + 0.5 * softnessPixels) * perPixel;
}

// Share of a dot. It is whole: it has the amount of its centre, and ends only with what it is on.
float dotAt(Dot mark, Placed own, ivec2 at) {
  vec2 way = mark.point - own.place;
  ivec2 centre = ivec2(floor(vec2(at) + 0.5 + inverse(own.gradient) * way));
  ivec2 shown = inPicture(centre);
  Spot there = spotAt(shown);
  bool isShown = there.isHere;
#if defined(ON_SMOKE) || defined(ON_SURFACES)
  // Another puff or surface can be there.
  vec2 off = abs(placeThere(shown) + own.gradient * vec2(centre - shown) - mark.point);
  vec2 slack = 2.0 * (abs(own.gradient[0]) + abs(own.gradient[1]));
  isShown = isShown && all(lessThan(off, slack));
#endif
  float perPixel = pixelAlong(way, own.gradient);
  float pixels = isShown ? sqrt(mark.squared * there.amount) / perPixel : 0.0;
  // Dots that are smaller than a pixel are lighter instead.
  float opacity = min(1.0, 4.0 * pixels * pixels);
  return opacity * coverOf(max(pixels, 0.5) - length(way) / perPixel);
}

#ifdef ON_BACKDROP
float dotsAt(Placed own, ivec2 at) {
  float pitch = levelOf(length(own.gradient[0])).x;
  return dotAt(Dot(floor(own.place / pitch + 0.5) * pitch, pitch * pitch / PI), own, at);
}
#else
// Dots at the points of the coarser lattice, then those between four of them, then those between two.
float dotsAt(Placed own, ivec2 at) {
  vec2 level = levelOf(sqrt(abs(determinant(own.gradient))));
  float second = smoothstep(0.0, 0.5, level.y);
  float third = smoothstep(0.5, 1.0, level.y);
  float whole = level.x * level.x / (PI * (1.0 + second + 2.0 * third));
  vec2 coarse = own.place / level.x;
  vec2 middle = floor(coarse) + 0.5;
  vec2 nearest = floor(coarse + 0.5);
  vec2 beside = abs(coarse - middle);
  vec2 edge = beside.x > beside.y ? vec2(nearest.x, middle.y) : vec2(middle.x, nearest.y);
  Dot marks[3] = Dot[3](
    Dot(nearest * level.x, whole), Dot(middle * level.x, whole * second), Dot(edge * level.x, whole * third)
  );
  // Most pixels are in the reach of one dot at most, and reading its centre takes the time.
  Dot reached[3];
  int count = 0;
  for (int index = 0; index < 3; ++index) {
    if (isReached(marks[index], own)) reached[count++] = marks[index];
  }
  float most = 0.0;
  for (int index = 0; index < count; ++index) most = max(most, dotAt(reached[index], own, at));
  return most;
}
#endif
#elif defined(GRAIN)
// A random number from 0 to 1 at each point of a lattice, smooth between them. They repeat after a full turn of the camera.
// @param turn number of points in a full turn
float noiseAt(vec2 point, float turn) {
  vec2 corner = floor(point);
  vec2 share = point - corner;
  share *= share * (3.0 - 2.0 * share);
  vec2 columns = corner.x + vec2(0.0, 1.0);
  columns -= turn * floor((columns + 0.5) / turn);
  uvec2 x = uvec2(columns) * 0x8da6b343u;
  uvec2 y = uvec2(ivec2(corner.y + vec2(0.0, 1.0))) * 0xd8163841u;
  uvec4 hash = uvec4(x, x) + y.xxyy;
  hash = (hash ^ (hash >> 15u)) * 0x2c1b3c6du;
  hash = (hash ^ (hash >> 12u)) * 0x297a2d39u;
  // Floats hold 24 bits, and signed integers are faster to convert.
  vec4 numbers = vec4(ivec4((hash ^ (hash >> 15u)) >> 8u)) / 16777215.0;
  vec2 across = mix(numbers.xz, numbers.yw, share.x);
  return mix(across.x, across.y, share.y);
}

// Grains of two sizes, of which one fades as the other appears; of one size on the backdrop.
float grainAt(Placed own, float amount) {
  // The noise has nearly a normal distribution, whose quantiles are about 0.6 standard deviations times the logit.
  const float SPREAD = 0.6 * 0.2145;
  vec2 level = levelOf(sqrt(abs(determinant(own.gradient))));
  vec2 point = own.place / level.x;
  float turn = max(round(fullTurn / level.x), 1.0);
#ifdef ON_BACKDROP
  float noise = noiseAt(point, turn) - 0.5;
#else
  vec2 both = vec2(noiseAt(point, turn), noiseAt(2.0 * point, 2.0 * turn)) - 0.5;
  float noise = dot(normalize(vec2(1.0 - level.y, level.y)), both);
#endif
  float inside = SPREAD * log(amount / (1.0 - amount)) - noise;
  return amount > 0.0 ? coverOf(inside * pitchPixels) : 0.0;
}
#elif defined(LINES) || defined(CROSSHATCH)
// Lines at equal angles from an axis on smoke, at equal distances elsewhere.
float linesAt(Placed own, vec2 across, float amount) {
#ifdef ON_SMOKE
  vec3 axis = vec3(across.x * tilt.x - across.y * tilt.y, across.x * tilt.y + across.y * tilt.x, 0.0);
  float sine = dot(own.place, axis);
  vec2 slope = axis * own.gradient * inversesqrt(max(1.0 - sine * sine, 1e-4));
  return lineAt(asin(clamp(sine, -1.0, 1.0)), slope, amount);
#else
  return lineAt(dot(across, own.place), across * own.gradient, amount);
#endif
}
#endif

// The amount of each of two lines that cross and together cover an amount.
float crossed(float amount) {
  return 1.0 - sqrt(1.0 - amount);
}

// @param placed at the pixel
float shareAt(ivec2 at, Placed placed, float amount) {
#if defined(DOTS)
  return dotsAt(placed, at);
#elif defined(GRAIN)
  return grainAt(placed, amount);
#elif defined(LINES)
  return linesAt(placed, vec2(0.0, 1.0), amount);
#elif defined(CROSSHATCH)
  float second = crossed(max(0.0, 2.0 * amount - patternCoverage));
  return max(linesAt(placed, vec2(0.0, 1.0), crossed(amount)), linesAt(placed, vec2(1.0, 0.0), second));
#else
  return amount;
#endif
}

void main() {
#ifdef ON_HOST
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOrigin);
#else
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#endif
#ifdef SHIFTED
  ivec2 at = pixel - shift;
#else
  ivec2 at = pixel;
#endif
  ivec2 inside = inPicture(at);
  Spot own = spotAt(inside);
  if (!own.isHere) discard;
  Placed placed = placedAt(inside, own);
#ifdef SHIFTED
  // What is at the border continues beside the picture.
  placed.place += placed.gradient * vec2(at - inside);
#endif
  float share = shareAt(at, placed, own.amount);
#ifdef ON_HOST
  vec3 color = isLinear ? linearFromDisplay(patternColor) : patternColor;
  covered = vec4(color, share);
#else
#ifdef SHIFTED
  own = spotAt(pixel);
#endif
  covered = vec4(share * (1.0 - own.ink), 0.0, 0.0, 1.0);
#endif
}
