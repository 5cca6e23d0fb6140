precision highp float;
precision highp int;
precision highp sampler2DArray;

// The shadow volume of a particle: the puff swept along the light, as two nailboards with one screen footprint.
// The front one carries the depth where each view ray enters the volume, the back one the depth where it leaves.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform float near;
uniform vec3 travelInWorld;
uniform vec3 receiversMin;
uniform vec3 receiversMax;
uniform float shadowRadius;
uniform float leastCap;
uniform sampler2DArray startCaps;

in vec2 corner;
in vec4 place;
in uvec2 look;

flat out vec3 start;
flat out float extent;
flat out float radius;

#include ../lib/look.glsl
#include ../lib/box.glsl

const float PI = 3.14159265359;
// Radii between the farthest lit point and the cap, against rounding in depth.
const float CAP_SLACK = 0.02;

// How far behind the centre (in radii, along the light's travel) the puff's farthest lit point lies, from the baked table.
float startCap(vec3 travel, vec3 centre, bool perspective) {
  float roll = rollOf(look);
  vec2 turn = vec2(cos(roll), sin(roll));
  vec3 towards = -travel;
  towards.xy = vec2(turn.x * towards.x + turn.y * towards.y, turn.x * towards.y - turn.y * towards.x);
  vec2 angles = vec2(atan(towards.y, towards.x) / (2.0 * PI) + 0.5, acos(clamp(towards.z, -1.0, 1.0)) / PI);
  float cap = textureLod(startCaps, vec3(angles, float(variationOf(look))), 0.0).r;
  // A nailboard is sheared along its view rays: relief moves a fragment sideways, towards the middle of the picture.
  float shear = perspective ? dot(travel.xy, centre.xy / centre.z) : 0.0;
  return max(max(cap, 0.0) + max(0.0, shear) + CAP_SLACK, leastCap);
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

void main() {
  bool perspective = clipFromView[2][3] != 0.0;
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  vec3 travel = mat3(viewFromWorld) * travelInWorld;
  radius = place.w * shadowRadius;
  float cap = startCap(travel, centre, perspective) * place.w;
  extent = exitFromBox(place.xyz, travelInWorld, receiversMin, receiversMax, radius) - cap;
  start = centre + cap * travel;
  if (extent <= 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec3 end = start + extent * travel;
  float startSpan = perspective ? projectedRadius(start, radius) : radius;
  float endSpan = perspective ? projectedRadius(end, radius) : radius;
  vec2 screen = corner;
  if (startSpan >= 0.0 && endSpan >= 0.0) {
    vec2 from = perspective ? start.xy / -start.z : start.xy;
    vec2 to = perspective ? end.xy / -end.z : end.xy;
    float span = max(startSpan, endSpan);
    vec2 along = to - from;
    float reach = length(along);
    along = reach > 1e-6 ? along / reach : vec2(1.0, 0.0);
    vec2 point = 0.5 * (from + to) + along * corner.x * (0.5 * reach + span) + vec2(-along.y, along.x) * corner.y * span;
    vec4 clip = perspective ? clipFromView * vec4(point, -1.0, 0.0) : clipFromView * vec4(point, 0.0, 1.0);
    screen = clip.xy / clip.w;
  }
  // Depth is written by the fragments; a constant here keeps the near and far planes from cutting the quad.
  gl_Position = vec4(screen, 0.0, 1.0);
}
