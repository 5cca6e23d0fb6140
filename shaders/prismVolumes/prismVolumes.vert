precision highp float;

// The shadow volume of a particle on GPUs that do not keep the depth that fragments write: a prism with closed ends
// that starts behind the flat body and extends along the light. src/passes/prisms.ts defines the order of its faces.
// Inputs: corner of the prism, position and radius in world space. Output: clip position.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec4 lightInWorld;
uniform vec3 receiversMin;
uniform vec3 receiversMax;
// In radii of the particle.
uniform float shadowRadius;

// (index around the prism, end + 2 x part), see src/passes/prisms.ts.
in vec2 corner;
in vec4 place;

#include ../lib/box.glsl
#include ../lib/light.glsl

const float PI = 3.14159265359;
const float SIDES = 12.0;
// Scale of the corners that makes the area equal to that of a circle of radius 1.
const float ROUND = 1.0233;
// Distance from the centre of a flat body to its farthest point, in radii, with a margin.
const float WIDEST_DISC = 1.15;
// A lamp closer to the centre than this many radii of the shadow is treated as if it were at that distance.
const float NEAREST = 1.2;
const vec4 NOWHERE = vec4(0.0, 0.0, 2.0, 1.0);

// Distance beyond the centre at which the volume has left all receivers, metres; 0 if the puff contains the light.
float exitOf(float ball, float growth) {
  vec3 travel = -towardsLightFrom(lightInWorld, place.xyz);
  float exit = exitFromBox(place.xyz, travel, receiversMin, receiversMax, ball, growth);
  if (lightInWorld.w == 0.0) return exit;
  float way = length(place.xyz - lightInWorld.xyz);
  return way > ball ? min(exit, farthestCorner(lightInWorld.xyz, receiversMin, receiversMax) - way) : 0.0;
}

// The direction perpendicular to the axis and away from the camera, in which side 0 faces. Bit-identical for all
// corners.
vec3 awayFromEye(vec3 centre, vec3 axis) {
  vec3 sight = clipFromView[2][3] != 0.0 ? centre : vec3(0.0, 0.0, -1.0);
  vec3 across = sight - dot(sight, axis) * axis;
  vec3 any = cross(axis, abs(axis.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
  return normalize(dot(across, across) > 1e-10 * dot(sight, sight) ? across : any);
}

// Whether a cap is drawn in this part: caps that face away from the camera first, caps that face it last.
bool isPass(int pass, float end, vec3 middle, vec3 axis) {
  vec3 sight = clipFromView[2][3] != 0.0 ? middle : vec3(0.0, 0.0, -1.0);
  bool facesEye = dot(sight, axis) * (1.0 - 2.0 * end) > 0.0;
  return pass == 0 || (pass == 2) == facesEye;
}

void main() {
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  vec3 axis = -towardsLightFrom(viewFromWorld * lightInWorld, centre);
  float ball = place.w * shadowRadius;
  float growth = lightInWorld.w * ball / max(length(place.xyz - lightInWorld.xyz), NEAREST * ball);
  // The body is a disc through the centre that faces the camera: no point of it is farther along the light.
  float cap = WIDEST_DISC * place.w * length(axis.xy);
  float extent = exitOf(ball, growth);

  float end = mod(corner.y, 2.0);
  vec3 middle = centre + mix(cap, extent, end) * axis;
  gl_Position = NOWHERE;
  if (extent <= cap || !isPass(int(corner.y) / 2, end, middle, axis)) return;
  vec3 away = awayFromEye(centre, axis);
  float angle = (mod(corner.x, SIDES) - 0.5) * 2.0 * PI / SIDES;
  vec3 outward = cos(angle) * away + sin(angle) * cross(axis, away);
  float radius = ROUND * (ball + growth * mix(cap, extent, end));
  gl_Position = clipFromView * vec4(middle + radius * outward, 1.0);
}
