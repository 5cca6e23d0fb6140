// The frame of a shadow volume and its discs, which volume.glsl computes. Define VOLUME as `flat out` in vertex shaders and
// `flat in` in fragment shaders.

// The transform from view space to the frame of the volume, whose origin is the middle of the volume's start: two axes
// perpendicular to the light, then the direction of the light's travel, in puff radii. The xyz components are the first
// two axes and the origin. The w components are the length of the volume, its scale at the start, and the growth of the
// scale for each radius along the light. No value depends on the corner, so rounding is the same for volumes of every
// length.
VOLUME vec4 rightAndLength;
VOLUME vec4 upAndScale;
VOLUME vec4 eyeAndGrowth;
// Discs on the plane where the scale is 1: centre and squared radius.
VOLUME vec3 discs[LOBES];
#ifdef DEFORMED
// Factor on the second coordinate of the frame that makes the discs of stretched lobes circles.
VOLUME float squeeze;
#endif

// The z axis of view space in the frame.
vec3 backInFrame() {
  return cross(rightAndLength.xyz, upAndScale.xyz) * inversesqrt(dot(upAndScale.xyz, upAndScale.xyz));
}

vec3 squeezed(vec3 place) {
#ifdef DEFORMED
  place.y *= squeeze;
#endif
  return place;
}

// A place in view space in the frame.
vec3 inFrame(vec3 place) {
  return squeezed(eyeAndGrowth.xyz + place.x * rightAndLength.xyz + place.y * upAndScale.xyz + place.z * backInFrame());
}

// Scale of the discs at a distance behind the start. Seen from the light, xy over this scale is on the plane of the discs.
float scaleAt(float along) {
  return upAndScale.w + eyeAndGrowth.w * along;
}
