// Inserted into lib/volume.glsl. 8: declarations.
#include place.glsl

// Centres of the first and of the third bite in the frame of the discs, where balls are balls along the light, too.
flat out vec3 firstBiteSeen;
flat out vec3 sideBiteSeen;
// 255 times the erosion, plus half of the width across the stretch.
flat out float erosionAndWidth;

// Distance from the centre to the end of the puff, in radii along the light's travel.
float behind = 0.0;
#ifdef DEFORMED
// Half of the extent of a stretched ball along the light in its radii; factor on depths where balls are balls, and shear.
vec3 supportDepthShear;
#endif

vec3 inDiscFrame(vec3 seen) {
#ifdef DEFORMED
  return vec3(seen.x, seen.y * widthTiltFactor.z, supportDepthShear.y * (seen.z + supportDepthShear.z * seen.y));
#else
  return seen;
#endif
}
#pragma section
  // 9: before the slack of the start. Bites open the puff to the light up to its end.
  cap = mix(cap, max(cap, behind), min(erosionOf(attributes) / EROSION_LEAD, 1.0));
#pragma section
  // 10: for each disc.
#ifdef DEFORMED
  behind = max(behind, middle + lobe.w * supportDepthShear.x);
  middle = inDiscFrame(frameFromPuff * lobe.xyz).z;
#else
  behind = max(behind, middle + lobe.w);
#endif
#pragma section
  // 11: after the discs.
  firstBiteSeen = inDiscFrame(frameFromPuff * firstBite(variation));
  sideBiteSeen = inDiscFrame(frameFromPuff * sideBite(variation));
  float width = 1.0;
#ifdef DEFORMED
  width = widthTiltFactor.x;
#endif
  erosionAndWidth = float(attributes.w >> 24u) + 0.5 * width;
#pragma section
  // 12: of deformed puffs.
  supportDepthShear = vec3(sqrt(support), projection.depth, dot(projection.shear, along));
