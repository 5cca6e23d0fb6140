// ERODED: the bites of a puff that dissolves, three balls that grow with its erosion and are cut out of its lobes. Two lie
// on opposite sides and leave a cup, then a ring; the third opens the ring to a hook. They turn and stretch like lobes.

// Distance of the first two bites and of the third from the centre, in puff radii.
const vec2 BITE_DISTANCES = vec2(1.15, 1.25);
// Erosion at which the second and the third bite begin.
const vec2 BITE_STARTS = vec2(0.2, 0.4);
// How far the first two bites and the third have grown when the erosion is 1.
const vec2 BITE_DEPTHS = vec2(1.08, 0.75);
// Erosion up to which the start of the shadow moves behind the puff and no bite has reached it.
const float EROSION_LEAD = 0.0625;

// The axis of the first two bites and the direction of the third, unit vectors in the frame of the puff.
vec3 biteAxis(int variation) {
  const float GOLDEN_ANGLE = 2.399963229728653;
  float angle = GOLDEN_ANGLE * float(variation);
  return vec3(0.6 * cos(angle), 0.8, 0.6 * sin(angle));
}

vec3 biteSide(int variation) {
  const float GOLDEN_ANGLE = 2.399963229728653;
  float angle = GOLDEN_ANGLE * float(variation);
  return vec3(-sin(angle), 0.0, cos(angle));
}

// Centre and radius of the bites; a negative radius for none.
vec4 bites[3];
// Heights over a point of the image plane: the middles of the bites, half of their extents, or less than 0 where they are
// missed, and their far walls.
vec3 biteMiddles;
vec3 biteHalves;
vec3 biteWalls;
// How far within a lobe the far walls are.
vec3 wallDepths;
// Positive if a lobe is over the point.
float lobesOver;
// Height of the highest point that is left on a lobe.
float lobeHeight;

// Height where nothing is left.
const float NOTHING = -1e8;

// `axis` and `side` are those of the puff in another frame.
void placeBites(float erosion, vec3 axis, vec3 side) {
  vec3 starts = vec3(EROSION_LEAD, BITE_STARTS);
  vec3 grown = (vec3(erosion) - starts) / (1.0 - starts);
  vec3 distances = BITE_DISTANCES.xxy;
  vec3 eased = grown * (2.0 - grown);
  vec3 radii = mix(vec3(-1.0), distances - 1.0 + BITE_DEPTHS.xxy * eased, greaterThan(grown, vec3(0.0)));
  bites[ 0 ] = vec4(distances.x * axis, radii.x);
  bites[ 1 ] = vec4(-distances.y * axis, radii.y);
  bites[ 2 ] = vec4(distances.z * side, radii.z);
}

// Whether one bite contains a lobe.
bool isEaten(vec4 lobe) {
  return distance(lobe.xyz, bites[ 0 ].xyz) + lobe.w < bites[ 0 ].w
    || distance(lobe.xyz, bites[ 1 ].xyz) + lobe.w < bites[ 1 ].w
    || distance(lobe.xyz, bites[ 2 ].xyz) + lobe.w < bites[ 2 ].w;
}

// Meets a ray with the bites, by the squares of half of their extents.
void meetBites(vec3 squares) {
  biteHalves = mix(vec3(-1.0), sqrt(max(squares, 0.0)), greaterThan(squares, vec3(0.0)));
  biteWalls = biteMiddles - biteHalves;
  wallDepths = vec3(-1.0);
  lobesOver = 0.0;
  lobeHeight = NOTHING;
}

// Whether no bite contains a height. A negative `self` excludes a bite.
bool isLeft(float height, vec3 self) {
  vec3 within = biteHalves - abs(height - biteMiddles) + self;
  return max(max(within.x, within.y), within.z) <= 0.0;
}

// Adds a lobe with its middle height and the square of half of its extent, which is negative where the lobe is missed.
void meetLobe(float middle, float halfSquared) {
  float halfExtent = sqrt(max(halfSquared, 0.0));
  float front = middle + halfExtent;
  lobeHeight = max(lobeHeight, halfSquared > 0.0 && isLeft(front, vec3(0.0)) ? front : NOTHING);
  wallDepths = max(wallDepths, halfExtent - abs(biteWalls - middle));
  lobesOver = max(lobesOver, halfSquared);
}

// The height of a bite's wall if it is left.
float wallHeight(float wall, float depth, float halfExtent, vec3 self) {
  return depth > 0.0 && halfExtent > 0.0 && isLeft(wall, self) ? wall : NOTHING;
}

// Of the highest point that is left after all lobes: its height, and the bite whose wall it is on, -1 for a lobe.
struct Remains {
  float height;
  int bite;
};

Remains remaining() {
  const float FAR = -1e9;
  float first = wallHeight(biteWalls.x, wallDepths.x, biteHalves.x, vec3(FAR, 0.0, 0.0));
  float second = wallHeight(biteWalls.y, wallDepths.y, biteHalves.y, vec3(0.0, FAR, 0.0));
  float third = wallHeight(biteWalls.z, wallDepths.z, biteHalves.z, vec3(0.0, 0.0, FAR));
  float height = max(max(first, second), max(third, lobeHeight));
  return Remains(height, height == lobeHeight ? -1 : height == first ? 0 : height == second ? 1 : 2);
}
