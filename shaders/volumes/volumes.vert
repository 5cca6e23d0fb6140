precision highp float;
precision highp int;
precision highp sampler2DArray;

// The shadow volume of a particle: the puff swept along the light, as two nailboards with one screen footprint.
// The front one carries the depth where each view ray enters the volume, the back one the depth where it leaves.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform float near;
uniform vec4 lightInWorld;
uniform vec3 receiversMin;
uniform vec3 receiversMax;
uniform float shadowRadius;
uniform float leastCap;
uniform float depth;
uniform bool facesEye;
uniform sampler2DArray startCaps;

in vec2 corner;
in vec4 place;
in uvec2 look;

flat out vec3 start;
flat out vec3 axis;
flat out float extent;
flat out float radius;
flat out float growth;

#include ../lib/look.glsl
#include ../lib/orientation.glsl
#include ../lib/box.glsl
#include ../lib/light.glsl

// A lamp so near that the shadow would open more than this throws none that is wider.
const float WIDEST = 2.0;
const float PI = 3.14159265359;
// Radii between the farthest lit point and the cap, against rounding in depth.
const float CAP_SLACK = 0.02;

// The light's travel in the frame of the puff: a billboard rolls about the view axis, lobes stand in the world.
vec3 travelInPuff(vec3 travel) {
  if (!facesEye) return travel * (mat3(viewFromWorld) * worldFromPuff(look));
  vec2 turn = vec2(cos(rollOf(look)), sin(rollOf(look)));
  return vec3(turn.x * travel.x + turn.y * travel.y, turn.x * travel.y - turn.y * travel.x, travel.z);
}

// A nailboard is sheared along its view rays: its relief moves a fragment sideways, in radii. How much farther behind
// that can take a lit point.
float shearOf(vec3 travel, vec3 centre) {
  // What of a puff is seen lies no deeper than a bound behind its centre plane, and of the unit ball height times
  // distance from the view axis is at most a half.
  float slope = dot(travel.xy, centre.xy / centre.z);
  if (facesEye) return max(0.0, slope);
  return max(slope, -depth * slope) - 0.5 * length(travel.xy) * place.w / centre.z;
}

// How far behind the centre (in radii, along the light's travel) the puff's farthest lit point lies, from the baked table.
float startCap(vec3 travel, vec3 centre, bool perspective) {
  vec3 towards = -travelInPuff(travel);
  vec2 angles = vec2(atan(towards.y, towards.x) / (2.0 * PI) + 0.5, acos(clamp(towards.z, -1.0, 1.0)) / PI);
  int variation = variationOf(look) % textureSize(startCaps, 0).z;
  float cap = textureLod(startCaps, vec3(angles, float(variation)), 0.0).r;
  float shear = perspective ? shearOf(travel, centre) : 0.0;
  return max(cap, leastCap) + shear + CAP_SLACK;
}

// Radius, on the plane at unit depth, of a circle around the projected centre that covers the projected ball; negative
// when the ball reaches behind or beside the eye.
float projectedRadius(vec3 centre, float ball) {
  float squared = dot(centre, centre) - ball * ball;
  if (squared <= 0.0 || -centre.z <= near + ball) return -1.0;
  float slope = length(centre.xy) / -centre.z;
  float widening = ball * inversesqrt(squared);
  float remaining = 1.0 - slope * widening;
  return remaining > 0.1 ? (slope + widening) / remaining - slope : -1.0;
}

// The directions, as slopes against the view axis in one plane through it, in which two balls and all between them lie.
// Points are (sideways, forward). Balls beside or behind the eye leave a side open; empty where nothing lies in front.
vec2 slopesOf(vec2 from, vec2 to, vec2 balls) {
  const float OPEN = 1e4;
  const float HALF_TURN = 3.14159265359;
  const float ASIDE = 1.57;
  vec2 reach = vec2(length(from), length(to));
  if (any(lessThanEqual(reach, balls))) return vec2(-OPEN, OPEN);
  float start = atan(from.x, from.y);
  float turn = atan(to.x, to.y) - start;
  float end = start + turn - 2.0 * HALF_TURN * round(turn / (2.0 * HALF_TURN));
  vec2 widening = asin(balls / reach);
  vec2 span = vec2(min(start - widening.x, end - widening.y), max(start + widening.x, end + widening.y));
  if (span.y - span.x >= HALF_TURN) return vec2(-OPEN, OPEN);
  // Seen from the other side of the half turn behind the eye, the same stretch may lie in front.
  if (span.x > ASIDE) span -= 2.0 * HALF_TURN;
  if (span.y < -ASIDE) span += 2.0 * HALF_TURN;
  if (span.x > ASIDE || span.y < -ASIDE) return vec2(0.0);
  return vec2(span.x <= -ASIDE ? -OPEN : tan(span.x), span.y >= ASIDE ? OPEN : tan(span.y));
}

// Corner of the oriented box around the projections of two balls, on the plane at unit depth.
vec2 boxCorner(vec2 from, vec2 to, float span) {
  vec2 along = to - from;
  float reach = length(along);
  along = reach > 1e-6 ? along / reach : vec2(1.0, 0.0);
  return 0.5 * (from + to) + along * corner.x * (0.5 * reach + span) + vec2(-along.y, along.x) * corner.y * span;
}

// Normalised device coordinates of this corner of the footprint.
vec2 footprint(vec3 end, bool perspective) {
  float endRadius = radius + growth * extent;
  if (!perspective) return (clipFromView * vec4(boxCorner(start.xy, end.xy, endRadius), 0.0, 1.0)).xy;
  vec2 spans = vec2(projectedRadius(start, radius), projectedRadius(end, endRadius));
  if (min(spans.x, spans.y) >= 0.0) {
    vec2 point = boxCorner(start.xy / -start.z, end.xy / -end.z, max(spans.x, spans.y));
    return (clipFromView * vec4(point, -1.0, 0.0)).xy;
  }
  vec2 balls = vec2(radius, endRadius);
  vec2 x = slopesOf(vec2(start.x, -start.z), vec2(end.x, -end.z), balls);
  vec2 y = slopesOf(vec2(start.y, -start.z), vec2(end.y, -end.z), balls);
  vec2 point = mix(vec2(x.x, y.x), vec2(x.y, y.y), 0.5 + 0.5 * corner);
  // Corners of open sides stay near the screen, where they are precise; an upright box may be cut so.
  return clamp((clipFromView * vec4(point, -1.0, 0.0)).xy, -4.0, 4.0);
}

// How much wider the shadow of a ball gets with each unit of the way; 0 under a sun.
float growthOf(float ball) {
  if (lightInWorld.w == 0.0) return 0.0;
  vec3 offset = place.xyz - lightInWorld.xyz;
  return min(ball * inversesqrt(max(dot(offset, offset) - ball * ball, 1e-12)), WIDEST);
}

// How far beyond the centre the volume has left everything that could receive it.
float exitOf(float ball) {
  vec3 travel = -towardsLightFrom(lightInWorld, place.xyz);
  float exit = exitFromBox(place.xyz, travel, receiversMin, receiversMax, ball, growth);
  if (lightInWorld.w == 0.0) return exit;
  float way = length(place.xyz - lightInWorld.xyz);
  // From within a puff a lamp lights all of it.
  return way > ball ? min(exit, farthestCorner(lightInWorld.xyz, receiversMin, receiversMax) - way) : 0.0;
}

void main() {
  bool perspective = clipFromView[2][3] != 0.0;
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  axis = -towardsLightFrom(viewFromWorld * lightInWorld, centre);
  float ball = place.w * shadowRadius;
  growth = growthOf(ball);
  float cap = startCap(axis, centre, perspective) * place.w;
  extent = exitOf(ball) - cap;
  start = centre + cap * axis;
  // The cone that touches the ball all round.
  radius = ball * sqrt(1.0 + growth * growth) + growth * cap;
  if (extent <= 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  // Depth is written by the fragments; a constant here keeps the near and far planes from cutting the quad.
  gl_Position = vec4(footprint(start + extent * axis, perspective), 0.0, 1.0);
}
