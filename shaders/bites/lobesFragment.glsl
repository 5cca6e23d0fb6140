// Added to bodies/lobes.frag.
float spreadAt(float height) {
  return 1.0;
}

#include cut.glsl

// Lines are as if no surface was steeper than this against the eye: the least cosine.
const float STEEPEST_LINED = 0.3;
// Width of the lines of bites in widths of the outline, so that thin pieces do not become black.
const float BITE_LINE = 0.65;

// Height of the front of what is left of a lobe.
float frontOfRest(vec4 lobe, float squared) {
  float halfExtent = sqrt(max(squared, 0.0));
  float top = topOf(lobe.z, halfExtent);
  return squared > 0.0 && top > lobe.z - halfExtent ? top : NOWHERE;
}

// The width of a line along an edge, on a surface of which the height falls by `lean`, if the distance from the edge grows along
// a direction, times the length of this direction.
float widthAcross(vec3 direction, vec2 lean) {
  return BITE_LINE * length(viewGradient(direction.xy - direction.z * lean));
}

// Whether a place of the puff, or of the ring beside it, is in the line of a bite. Replaces the normals of walls.
bool hasBiteLine(vec3 place, bool isRing, vec4 line, float reach, inout vec3 normal, inout vec3 viewNormal) {
  // The place, or that of the silhouette beside it, where lobes are balls.
  vec3 shown = place;
  if (isRing) {
    vec2 towards = normalize(line.xy - place.xy);
    shown.xy += line.w * length(viewGradient(towards)) * towards;
  }
  vec3 fromNear = shown - nearBite;
  vec3 fromSide = shown - sideBite;
  vec3 fromFar = shown + nearBite;
  vec3 powers = vec3(dot(fromNear, fromNear), dot(fromSide, fromSide), dot(fromFar, fromFar)) - biteRadii * biteRadii;
  if (isRing) {
    // The line around a lobe tapers towards a bite.
    if (any(lessThan(powers, 4.0 * line.w * biteRadii))) discard;
    return false;
  }
  bvec3 isOfWall = equal(vec3(place.z), walls);
  bool isWall = any(isOfWall);
  vec3 outOfLobes = viewNormal;
  if (isWall) normal = viewNormal = -normalize(isOfWall.x ? fromNear : isOfWall.y ? fromSide : fromFar);
  vec2 lean = viewNormal.xy / max(viewNormal.z, STEEPEST_LINED);
  vec3 widths = vec3(widthAcross(fromNear, lean), widthAcross(fromSide, lean), widthAcross(fromFar, lean));
  // Between two walls, each has half of the line.
  if (isWall) widths *= mix(vec3(0.5), vec3(1.0), greaterThan(vec3(fromNear.z, fromSide.z, fromFar.z), vec3(0.0)));
  // Where the wall of a bite meets the front of a lobe, the line is on the front, unless the front is too narrow.
  float share = min(1.0, 1.0 - 2.0 * outOfLobes.z);
  bool isBehind = isWall && -deepest < share * reach * widthAcross(outOfLobes, lean);
  return isBehind || any(lessThan(powers + 1e3 * vec3(isOfWall), 2.0 * reach * sign(biteRadii) * widths));
}
