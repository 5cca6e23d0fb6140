// The shadow volume of a particle: the discs that its lobes show to the light, extruded along the light rays. Everything
// that is constant for a particle is computed here. Call writeVolume after reading a row; needs rows.glsl.
// CUT: puffs whose shadow is only a part of the discs. For puffs with bites, src/renderer/bites.ts adds bites/volumeVertex.glsl; for
// billboards that throw silhouettes, src/renderer/gpu/billboardTextures.ts adds silhouettes/volumeVertex.glsl.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform float near;
uniform vec4 lightInWorld;
uniform vec3 receiversMin;
uniform vec3 receiversMax;
uniform float minCap;
uniform float depth;
uniform bool facesEye;
// For shadows of objects, which do not shrink near the camera as puffs do.
uniform bool keepsSize;
// Farthest distance from the centre, in radii, of a puff that is drawn as a flat disc; 0 if puffs have relief.
uniform float discReach;
uniform sampler2DArray startCaps;
// One row for each variation: LOBES lobes (xyz, radius), in puff radii.
uniform sampler2D casterTable;
// Radius of the bounding sphere of a puff, in puff radii.
uniform float reach;

#define VOLUME flat out
#include volumeFrame.glsl
#include clearance.glsl
#include attributes.glsl
#include orientation.glsl
#include box.glsl
#include light.glsl

const float PI = 3.14159265359;
// Distance between the farthest lit point and the start of the volume, in radii, against rounding of depth.
const float CAP_SLACK = 0.02;
// A lamp closer to the centre than this many bounding radii is treated as if it were at that distance.
const float NEAREST_LAMP = 1.2;
// A puff keeps 1.7 radii away from the camera, so it leaves the picture before it is nearer than this, in radii.
const float NEAREST_SHEARED = 0.5;

// The rotation from puff space to view space. A billboard rolls about the view axis; lobes are oriented in the world.
mat3 viewFromPuffOf(uvec4 attributes) {
  if (!facesEye) return mat3(viewFromWorld) * worldFromPuff(attributes);
  vec2 rotation = vec2(cos(rollOf(attributes)), sin(rollOf(attributes)));
  return mat3(vec3(rotation.x, rotation.y, 0.0), vec3(-rotation.y, rotation.x, 0.0), vec3(0.0, 0.0, 1.0));
}

// Extra distance, in radii, for the shear of a nailboard: its relief moves fragments along the view rays and so
// sideways, which can move a visible lit point farther behind the centre.
float shearOf(vec3 travel, vec3 centre) {
  float ahead = max(-centre.z, NEAREST_SHEARED * place.w);
  // The slopes of view rays, limited to the part of the puff that is inside the picture.
  vec2 scale = vec2(clipFromView[0][0], clipFromView[1][1]);
  vec2 ray = clamp(centre.xy / ahead, (clipFromView[2].xy - 1.0) / scale, (clipFromView[2].xy + 1.0) / scale);
  // The visible part of a puff is at most `depth` behind its centre plane. In the unit ball, height times distance from
  // the view axis is at most 1/2.
#ifdef DEFORMED
  float tallest = reach;
#else
  const float tallest = 1.0;
#endif
  float slope = -dot(travel.xy, ray);
  float shear = max(tallest * slope, -depth * slope);
  if (!facesEye) shear += 0.5 * tallest * tallest * length(travel.xy) * place.w / ahead;
  return shear;
}

#ifdef DEFORMED
// Distance from the centre to the farthest lit point for a ramp without light below N . L = 0, in radii along the light's
// travel; the form of deformed puffs is not baked.
float farthest;
// Width across the stretch; depth of the lit part of a lobe behind its centre, in its radii; factor on the second axis of the
// frame, which makes the discs of lobes circles.
vec3 widthTiltFactor;
#endif

// Distance from the centre to the start of a volume behind all points up to a cap, in radii along the light's travel.
float startBehind(float cap, vec3 travel, vec3 centre) {
  return cap + (clipFromView[2][3] != 0.0 ? shearOf(travel, centre) : 0.0) + CAP_SLACK;
}

// The same behind the puff's farthest lit point, from the baked table.
float startCap(vec3 travel, mat3 viewFromPuff, vec3 centre) {
#ifdef DEFORMED
  float cap = farthest;
#else
  vec3 towards = -travel * viewFromPuff;
  vec2 angles = vec2(atan(towards.y, towards.x) / (2.0 * PI) + 0.5, acos(clamp(towards.z, -1.0, 1.0)) / PI);
  int variation = variationOf(attributes) % textureSize(startCaps, 0).z;
  float cap = textureLod(startCaps, vec3(angles, float(variation)), 0.0).r;
#endif
  return startBehind(max(max(cap, minCap), discReach * length(travel.xy)), travel, centre);
}

// Distance beyond the centre at which the volume has left all receivers, metres; 0 if the puff contains the light.
float exitOf(float ball, float growth) {
  vec3 travel = -towardsLightFrom(lightInWorld, place.xyz);
  float exit = exitFromBox(place.xyz, travel, receiversMin, receiversMax, ball, ball * growth);
  if (lightInWorld.w == 0.0) return exit;
  float way = length(place.xyz - lightInWorld.xyz);
  return way > ball ? min(exit, farthestCorner(lightInWorld.xyz, receiversMin, receiversMax) - way) : 0.0;
}

vec4 lobeOf(int index, int variation) {
  vec4 lobe = texelFetch(casterTable, ivec2(index, variation), 0);
#ifdef DEFORMED
  lobe.xyz *= unfolded(index, casterAgeOf(attributes));
#endif
  return lobe;
}

// The disc that a lobe shows to a light at a distance of 1 / growth: the section of the light's tangent cone.
vec3 discOf(vec4 lobe, mat3 frameFromPuff, float growth) {
  vec3 seen = frameFromPuff * lobe.xyz;
#ifdef DEFORMED
  lobe.w *= widthTiltFactor.x;
  farthest = max(farthest, seen.z + lobe.w * widthTiltFactor.y);
  seen.y *= widthTiltFactor.z;
#endif
  float nearness = 1.0 / (1.0 + growth * seen.z);
  float radius = lobe.w * nearness;
  float slope = radius * growth;
  return vec3(seen.xy * nearness, radius * radius / (1.0 - slope * slope));
}

// Sides of the box around the discs, in the frame of the volume and in radii: along two axes, least and greatest.
vec4 sides;

// Extends the box around the discs.
void enclose(vec3 disc, mat2 sideAxes) {
  float radius = sqrt(disc.z);
#ifdef DEFORMED
  sideAxes[0].y /= widthTiltFactor.z;
  sideAxes[1].y /= widthTiltFactor.z;
#endif
  vec2 at = disc.xy * sideAxes;
  vec2 reached = radius * vec2(length(sideAxes[0]), length(sideAxes[1]));
  sides = vec4(min(sides.xy, at - reached), max(sides.zw, at + reached));
}

// Distance from the centre to the far side of a disc.
float farSide(vec3 disc) {
#ifdef DEFORMED
  return length(vec2(disc.x, disc.y / widthTiltFactor.z)) + sqrt(disc.z) / widthTiltFactor.z;
#else
  return length(disc.xy) + sqrt(disc.z);
#endif
}

// Computes the discs and their sides. Returns the radius of the circle about the centre that contains the discs.
float spreadDiscs(mat3 frameFromPuff, float growth, mat2 sideAxes) {
  int variation = variationOf(attributes) % textureSize(casterTable, 0).y;
  float widest = 0.0;
  sides = vec4(vec2(1e9), vec2(-1e9));
#ifdef DEFORMED
  farthest = 0.0;
#endif
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    discs[ i ] = discOf(lobeOf(UNROLLED_LOOP_INDEX, variation), frameFromPuff, growth);
    widest = max(widest, farSide(discs[ i ]));
    enclose(discs[ i ], sideAxes);
  }
  #pragma unroll_loop_end
  return widest;
}

// The ends of a volume in view space: centres, two axes, and scales of `sides` along them; the z of the
// point that is nearest to the eye.
struct Ends {
  vec3 start;
  vec3 end;
  mat2x3 sideAxes;
  vec2 scales;
  float nearestZ;
};

#ifdef CUT
// Writes the outputs of the part, and may narrow `sides`. Returns the start of the volume.
float writeCut(float cap, mat3 discsFromPuff, vec4 lengthwise, vec3 travel, vec3 centre, mat2 sideAxes);
#endif

// Computes the outputs. Returns false if the row has no volume.
bool writeVolume(out Ends ends) {
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  float end = place.w * endOf(attributes);
  float width = 1.0;
#ifdef DEFORMED
  vec4 stretch = stretchOf(attributes.w);
  width = acrossOf(stretch.w);
#endif
  if (!keepsSize) place.w *= clearance(centre, width);
  if (place.w <= 0.0) return false;
  vec3 axis = -towardsLightFrom(viewFromWorld * lightInWorld, centre);
  mat3 viewFromPuff = viewFromPuffOf(attributes);
  vec3 aside = normalize(abs(axis.x) < 0.7 ? vec3(0.0, -axis.z, axis.y) : vec3(axis.z, 0.0, -axis.x));
  mat3 frameFromView = transpose(mat3(aside, cross(axis, aside), axis));

#ifdef DEFORMED
  stretch.xyz = frameFromView * mat3(viewFromWorld) * stretch.xyz;
  Projection projection = projectionOf(stretch);
  vec2 along = projection.along;
  frameFromView = mat3(vec3(along.y, along.x, 0.0), vec3(-along.x, along.y, 0.0), vec3(0.0, 0.0, 1.0)) * frameFromView;
  float support = 1.0 + (stretch.w * stretch.w - 1.0) * stretch.z * stretch.z;
  float tilt = sqrt(max(0.0, support - 1.0 / (projection.depth * projection.depth)));
  widthTiltFactor = vec3(width, tilt, projection.factor);
#endif

  float distance = max(length(place.xyz - lightInWorld.xyz) / place.w, NEAREST_LAMP * reach);
  float growth = lightInWorld.w / distance;
  // One side along the picture, across the volume.
  vec3 across = cross(centre, axis);
  across = dot(across, across) > 1e-6 ? normalize(across) : aside;
  ends.sideAxes = mat2x3(across, cross(across, axis));
  mat2 sideAxes = mat2((frameFromView * ends.sideAxes[0]).xy, (frameFromView * ends.sideAxes[1]).xy);
  float widest = spreadDiscs(frameFromView * viewFromPuff, growth, sideAxes);
  float cap = startCap(axis, viewFromPuff, centre);
#ifdef CUT
  vec4 lengthwise = vec4(0.0, 0.0, 1.0, 1.0);
#ifdef DEFORMED
  lengthwise = vec4(projection.depth * vec3(0.0, dot(projection.shear, along), 1.0), width * sqrt(support));
#endif
  cap = writeCut(cap, frameFromView * viewFromPuff, lengthwise, axis, centre, sideAxes);
#endif
  float extent = min(exitOf(place.w * widest, growth / place.w), end) / place.w - cap;
  if (extent <= 0.0) return false;
#ifdef DEFORMED
  squeeze = widthTiltFactor.z;
#endif
  vec3 start = centre + cap * place.w * axis;
  float scale = 1.0 + growth * cap;
  rightAndLength = vec4(frameFromView[0] / place.w, extent);
  upAndScale = vec4(frameFromView[1] / place.w, scale);
  eyeAndGrowth = vec4(frameFromView * -start / place.w, growth);
  ends.scales = place.w * vec2(scale, scale + growth * extent);
  ends.start = start;
  ends.end = start + extent * place.w * axis;
  float box = length(max(-sides.xy, sides.zw));
  ends.nearestZ = max(ends.start.z + box * ends.scales.x, ends.end.z + box * ends.scales.y);
  return true;
}
