// Cuts bites out of a line above a point of a plane. Heights increase towards the eye or away from the light.
flat in vec3 nearBite;
flat in vec3 sideBite;
flat in float packedRadii;

const float NO_BITE = -1e8;
const float STEEP = 1e6;

// Of the near, the side and the far bite: radii, and the heights at which the line enters them.
vec3 biteRadii;
vec3 walls;
// Where the line leaves and enters the bites, the highest one first.
vec3 bitesEnd;
vec3 bitesStart;

// The end and the start of a bite. A line to a lamp is treated as parallel to the axis.
vec2 biteOver(vec2 point, vec3 centre, float radius) {
  vec2 beside = point * spreadAt(centre.z) - centre.xy;
  float squared = radius * radius - dot(beside, beside);
  float halfExtent = sqrt(max(squared, 0.0));
  return centre.z + vec2(squared > 0.0 ? halfExtent : NO_BITE, -halfExtent);
}

void meetBites(vec2 point) {
  const vec3 PLACES = vec3(1.0, 256.0, 65536.0);
  biteRadii = mod(floor(packedRadii / PLACES.xzy), 256.0) / 200.0;
  vec2 near = biteOver(point, nearBite, biteRadii.x);
  vec2 side = biteOver(point, sideBite, biteRadii.y);
  vec2 far = biteOver(point, -nearBite, biteRadii.z);
  walls = vec3(near.y, side.y, far.y);
  bool isFirst = sideBite.z > nearBite.z;
  bool isLast = sideBite.z < -nearBite.z;
  vec2 first = isFirst ? side : near;
  vec2 second = isFirst ? near : isLast ? far : side;
  vec2 third = isLast ? side : far;
  bitesEnd = vec3(first.x, second.x, third.x);
  bitesStart = vec3(first.y, second.y, third.y);
}

// The greatest height that is in a lobe and in no bite, less than the start of the lobe if none is. A bite of which the centre is
// lower cannot end in one that was passed. Arithmetic, because it takes less than a choice.
float topOf(float middle, float halfExtent) {
  float height = middle + halfExtent;
  height = min(height, max(bitesStart.x, STEEP * (height - bitesEnd.x)));
  height = min(height, max(bitesStart.y, STEEP * (height - bitesEnd.y)));
  return min(height, max(bitesStart.z, STEEP * (height - bitesEnd.z)));
}
