// The bites of a body. The code is inserted into lobes.frag when it is loaded, see src/smoke/bites.ts.
flat in vec4 biteAxisAndErosion;
flat in vec3 biteSideways;

#include ../lib/bites.glsl

// Directions in which an edge is sought, and the cosine of the angle between them.
const int LINE_SIDES = 8;
const float SIDE_COSINE = 0.70710678;

// A width along a direction of the image plane, where lobes are balls.
float widthAlong(vec2 direction, float width) {
#ifdef DEFORMED
  return width * length(viewGradient(direction));
#else
  return width;
#endif
}

vec2 directionOf(vec2 offset) {
  return offset * inversesqrt(max(dot(offset, offset), 1e-12));
}

// Square of half the extent of a ball over a point, with a radius that is larger by a width.
float halfSquared(vec4 ball, vec2 point, float width) {
  vec2 offset = point - ball.xy;
  float radius = max(ball.w + widthAlong(directionOf(offset), width), 0.0);
  return radius * radius - dot(offset, offset);
}

// What is left of the puff over a point, with lobes that are larger and bites that are smaller by a width.
Remains remainsOver(vec2 point, float width) {
  biteMiddles = vec3(bites[ 0 ].z, bites[ 1 ].z, bites[ 2 ].z);
  meetBites(
    vec3(
      halfSquared(bites[ 0 ], point, -width),
      halfSquared(bites[ 1 ], point, -width),
      halfSquared(bites[ 2 ], point, -width)
    )
  );
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    meetLobe(lobes[ i ].z, halfSquared(lobes[ i ], point, width));
  }
  #pragma unroll_loop_end
  return remaining();
}

vec3 biteCentre(int bite) {
  return bite == 0 ? bites[ 0 ].xyz : bite == 1 ? bites[ 1 ].xyz : bites[ 2 ].xyz;
}

// Whether a bite contains the nearest point of a silhouette, given as in nearerRim.
bool isRimBitten(vec4 line, vec2 point) {
  vec3 rim = vec3(point + line.w * directionOf(line.xy - point), line.z);
  return distance(rim, bites[ 0 ].xyz) < bites[ 0 ].w
    || distance(rim, bites[ 1 ].xyz) < bites[ 1 ].w
    || distance(rim, bites[ 2 ].xyz) < bites[ 2 ].w;
}

// What is left over a point; whether the wall of a bite ends there within the width of a line, away from the middle of the
// bite, before something else; and the line beside a bite, as in nearerRim: something is left within its width. A puff that is
// larger by the width contains all such points. `line` is the nearest silhouette; it stays if no bite is near.
// One loop, because software renderers run both sides of a branch, but leave a loop.
Remains bitten(vec2 point, float reach, inout vec4 line, out bool isEdge) {
  Remains remains;
  bool isHole = false;
  bool isOn = true;
  isEdge = false;
  vec2 offset = vec2(0.0);
  vec2 side = vec2(1.0, 0.0);
  float width = 0.0;
  for (int i = 0; i < LINE_SIDES + 2 && isOn; i++) {
    Remains found = remainsOver(point + offset, width);
    bool isFound = found.height > NOTHING;
    if (i == 0) {
      remains = found;
      isHole = !isFound;
      isOn = isHole ? lobesOver > 0.0 || isRimBitten(line, point) : found.bite >= 0;
      if (isHole && isOn) line.w = 1e9;
      width = isHole ? reach : 0.0;
      vec2 outward = directionOf(point - biteCentre(found.bite).xy);
      offset = isHole ? vec2(0.0) : outward * widthAlong(outward, reach);
    } else {
      isEdge = !isHole && isFound && found.bite != remains.bite;
      isOn = isHole && isFound == (i == 1);
      if (isHole && isFound && i > 1) line = vec4(point + offset, found.height, 0.5 * reach);
      offset = viewGradient(reach * side);
      side = SIDE_COSINE * vec2(side.x - side.y, side.x + side.y);
      width = 0.0;
    }
  }
  return remains;
}
