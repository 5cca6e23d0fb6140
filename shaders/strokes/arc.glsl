// The arc of a stroke, on the outline of a lobe. It is centred away from the light and leans to a direction that is fixed to
// the lobe. Lobes and points are in puff radii about the centre.
// DEFORMED: lobes and points are those of stretch.glsl, except in names with `view`.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform vec4 lightInView;
uniform float near;
// Pixels of the target for each CSS pixel.
uniform float pixelRatio;
// One row for each variation, see lobes.vert.
uniform sampler2D lobeTable;
// Numbers of row and lobe, four arcs in a texel: see src/renderer/passes/strokes/strokeArcs.ts.
uniform highp usampler2D arcs;

#include ../lib/fetchRow.glsl
#include ../lib/clearance.glsl
#include ../lib/pixel.glsl
#include ../lib/light.glsl
#include ../lib/attributes.glsl
#include ../lib/orientation.glsl
#include tile.glsl

// Half angle of the arc, radians.
const vec2 HALF_ANGLES = vec2(1.1, 1.7);
// Weight of the direction that is fixed to the lobe. The sum with the direction away from the light must not be short.
const float LEAN = 0.6;
const vec2 SHORTEST_SUM = vec2(0.1, 0.4);
// Length of an arc, CSS pixels, at which a stroke begins and is complete. Its ends are thinner than half a pixel.
const vec2 LENGTHS = vec2(14.0, 36.0);
// Age and remaining life, as a fraction of the lifetime, in which a stroke fades.
const float FADE = 0.25;

int lobeNumber;
vec3 centre;
float radius;
float pixel;
vec4 lobe;
// Height of the lobe before its outline, in view units.
float height;
float middle;
float halfAngle;
// CSS pixels.
float arcLength;
#ifdef DEFORMED
Projection projection;
#endif

// Four numbers in [0, 1), hashed from a particle and a lobe.
vec4 randomOf(int seed, int variation, int number) {
  uint bits = uint(seed) * 747796405u + uint(variation) * 2891336453u + uint(number) * 277803737u + 1u;
  bits = (bits ^ (bits >> 16u)) * 2246822519u;
  bits = (bits ^ (bits >> 13u)) * 3266489917u;
  bits ^= bits >> 16u;
  return vec4((uvec4(bits) >> uvec4(0u, 8u, 16u, 24u)) & 0xffu) / 256.0;
}

vec3 unitVector(vec2 random) {
  float z = 2.0 * random.x - 1.0;
  float angle = 6.28318530718 * random.y;
  return vec3(sqrt(1.0 - z * z) * vec2(cos(angle), sin(angle)), z);
}

vec2 viewPoint(vec2 point) {
#ifdef DEFORMED
  return scaled(projection, point, 1.0 / projection.factor);
#else
  return point;
#endif
}

vec2 unviewPoint(vec2 point) {
#ifdef DEFORMED
  return scaled(projection, point, projection.factor);
#else
  return point;
#endif
}

float viewHeight(float height, vec2 point) {
#ifdef DEFORMED
  return height / projection.depth - dot(projection.shear, viewPoint(point));
#else
  return height;
#endif
}

vec2 viewNormal(vec2 outward) {
#ifdef DEFORMED
  return normalize(scaled(projection, outward, projection.factor));
#else
  return outward;
#endif
}

vec2 outwardAt(float along) {
  float angle = middle + along * halfAngle;
  return vec2(cos(angle), sin(angle));
}

vec4 clipAt(vec2 beside) {
  return clipFromView * vec4(centre + vec3(beside, 0.0), 1.0);
}

vec2 pixelAt(vec2 beside) {
  vec4 clip = clipAt(beside);
  return (0.5 + 0.5 * clip.xy / clip.w) * viewport;
}

// Place on the outline, in view units beside the centre.
vec2 placeAt(float along) {
  return viewPoint(lobe.xy + lobe.w * outwardAt(along)) * radius;
}

float outlineZAt(float along) {
  return centre.z + viewHeight(lobe.z, lobe.xy + lobe.w * outwardAt(along)) * radius;
}

// Reads the row and the lobe of an arc.
void fetchArc(int arc) {
  int perLine = 4 * textureSize(arcs, 0).x;
  uint word = texelFetch(arcs, ivec2((arc % perLine) / 4, arc / perLine), 0)[arc % 4];
  fetchRow(int(word & 0xffffffu));
  lobeNumber = int(word >> 24u);
}

// Finds the arc that was read. Returns its opacity as far as it does not depend on other smoke.
float findArc() {
  centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  if (centre.z >= -near) return 0.0;
  float across = 1.0;
#ifdef DEFORMED
  vec4 stretch = stretchOf(attributes.w);
  across = acrossOf(stretch.w);
  projection = projectionOf(vec4(mat3(viewFromWorld) * stretch.xyz, stretch.w));
#endif
  radius = place.w * across * clearance(centre, across);
  if (radius <= 0.0) return 0.0;
  pixel = viewUnitsPerPixel(clipFromView, viewport, centre.z);
  int variation = variationOf(attributes) % textureSize(lobeTable, 0).y;
  lobe = texelFetch(lobeTable, ivec2(lobeNumber, variation), 0);
  vec4 random = randomOf(seedOf(attributes), variation, lobeNumber);
  mat3 viewFromPuff = mat3(viewFromWorld) * worldFromPuff(attributes);
#ifdef DEFORMED
  lobe.xyz *= unfolded(lobeNumber, ageOf(attributes));
#endif
  lobe.xyz = viewFromPuff * lobe.xyz;
  vec2 leaning = LEAN * (viewFromPuff * unitVector(random.xy)).xy - towardsLightFrom(lightInView, centre).xy;
#ifdef DEFORMED
  lobe.xyz = unstretched(projection, lobe.xyz / across);
  leaning = scaled(projection, leaning, 1.0 / projection.factor);
#endif
  middle = atan(leaning.y, leaning.x);
  halfAngle = mix(HALF_ANGLES.x, HALF_ANGLES.y, random.z);
  height = lobe.w * radius;
#ifdef DEFORMED
  height /= projection.depth;
#endif
  float age = ageOf(attributes);
  arcLength = 2.0 * halfAngle * lobe.w * radius / (pixel * pixelRatio);
  return smoothstep(SHORTEST_SUM.x, SHORTEST_SUM.y, length(leaning)) * smoothstep(LENGTHS.x, LENGTHS.y, arcLength) *
    smoothstep(0.0, FADE, age) * smoothstep(0.0, FADE, 1.0 - age);
}
