// Inserted into bodies/lobes.frag. 2: declarations. Outputs of lobesVertex.glsl.
flat in vec4 nearBite;
flat in vec4 sideBiteAndPair;

#include pair.glsl
#include cut.glsl

// Lines are as if no surface was steeper than this against the eye: the least cosine.
const float STEEPEST_LINED = 0.3;

// Radii of the far and of the side bite.
vec2 otherRadii;
// The walls of the near, the side and the far bite.
vec3 walls;
// A point of the puff, or of the silhouette beside it, where lobes are balls.
vec3 shown;
// Least distance from the surfaces of lobes, less than 0 within.
float deepest = 0.0;

vec2 biteOver(vec2 point, vec3 centre, float radius) {
  vec2 beside = point - centre.xy;
  return biteOf(centre.z, radius * radius - dot(beside, beside));
}

void meetBites(vec2 point) {
  vec3 centre = sideBiteAndPair.xyz;
  otherRadii = radiiOf(sideBiteAndPair.w);
  vec2 near = biteOver(point, nearBite.xyz, nearBite.w);
  vec2 far = biteOver(point, -nearBite.xyz, otherRadii.x);
  vec2 side = biteOver(point, centre, otherRadii.y);
  walls = vec3(near.y, side.y, far.y);
  bool isFirst = centre.z > nearBite.z;
  bool isLast = centre.z < -nearBite.z;
  vec2 first = isFirst ? side : near;
  vec2 second = isFirst ? near : isLast ? far : side;
  vec2 third = isLast ? side : far;
  bitesEnd = vec3(first.x, second.x, third.x);
  bitesStart = vec3(first.y, second.y, third.y);
}

vec2 viewGradient(vec2 outward);

// The width of a line along an edge, on a surface of which the height falls by `lean`, if the distance from the edge grows along
// a direction, times the length of this direction.
float widthAcross(vec3 direction, vec2 lean) {
  return length(viewGradient(direction.xy - direction.z * lean));
}
#pragma section
  // 3: the front of a lobe.
  float halfExtent = sqrt(max(squared, 0.0));
  float front = uncut(lobe.z + halfExtent);
  return squared > 0.0 && front > lobe.z - halfExtent ? front : NOWHERE;
#pragma section
  // 4: for each lobe.
  deepest = min(deepest, away);
#pragma section
  // 5: before the lobes.
  meetBites(point);
#pragma section
    // 6: where nothing is left.
    shown = vec3(point + line.w * normalize(line.xy - point), line.z);
#pragma section
  // 7: before lines.
  if (!isRing) shown = place;
  vec3 fromNear = shown - nearBite.xyz;
  vec3 fromSide = shown - sideBiteAndPair.xyz;
  vec3 fromFar = shown + nearBite.xyz;
  vec3 radii = vec3(nearBite.w, otherRadii.yx);
  vec3 powers = vec3(dot(fromNear, fromNear), dot(fromSide, fromSide), dot(fromFar, fromFar)) - radii * radii;
  // The line around a lobe tapers towards a bite.
  if (isRing && any(lessThan(powers, 4.0 * line.w * radii))) discard;
  bvec3 isOfWall = equal(vec3(height), walls);
  bool isWall = !isRing && any(isOfWall);
  vec3 outOfLobes = viewNormal;
  if (isWall) normal = viewNormal = -normalize(isOfWall.x ? fromNear : isOfWall.y ? fromSide : fromFar);
  vec2 lean = viewNormal.xy / max(viewNormal.z, STEEPEST_LINED);
  vec3 widths = vec3(widthAcross(fromNear, lean), widthAcross(fromSide, lean), widthAcross(fromFar, lean));
  // Between two walls, each has half of the line.
  if (isWall) widths *= mix(vec3(0.5), vec3(1.0), greaterThan(vec3(fromNear.z, fromSide.z, fromFar.z), vec3(0.0)));
  // Where the wall of a bite meets the front of a lobe, the line is on the front, unless the front is too narrow.
  float share = min(1.0, 1.0 - 2.0 * outOfLobes.z);
  bool isBehind = isWall && -deepest < share * reach * widthAcross(outOfLobes, lean);
  if (!isRing && (isBehind || any(lessThan(powers + 1e3 * vec3(isOfWall), 2.0 * reach * sign(radii) * widths)))) {
    isInk = true;
    viewZ -= lineDrop;
  }
