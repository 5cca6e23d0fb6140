precision highp float;

// Fragment shader of particle shadow volumes. Writes the depth at which the view ray of the pixel enters (front face)
// or leaves (back face) the volume. Seen from the light, the ray crosses the discs of the lobes; the shader takes the
// first entry and the last exit of all discs.
// Counted by depth pass: entries in front of the receiver minus exits in front of it is the number of volumes that
// contain the receiver.
// SILHOUETTE: billboards that throw silhouettes; src/renderer/gpu/billboardTextures.ts adds
// silhouettes/countedVolumesFragment.glsl.
// Inputs: volume frame and discs of volumes.vert. Output: depth only.
uniform mat4 clipFromView;
uniform float near;

uniform vec2 viewport;
uniform vec2 viewportOrigin;

#define VOLUME flat in
#include ../lib/volumeFrame.glsl
#include ../lib/depth.glsl
#include ../lib/pixel.glsl
#include ../insert/oblique.glsl

const float FAR = 1e20;

// Extends the interval (from, to) along a line by its intersection with a disc. The line has a unit direction and a
// signed distance from the origin, positive to the left.
void pass(inout vec2 stretch, vec3 disc, vec2 direction, float offset) {
  float beside = direction.x * disc.y - direction.y * disc.x - offset;
  float squared = disc.z - beside * beside;
  float middle = dot(disc.xy, direction);
  float halfChord = sqrt(squared);
  if (squared > 0.0) stretch = vec2(min(stretch.x, middle - halfChord), max(stretch.y, middle + halfChord));
}

// The view ray of the pixel in the frame of the volume, parameterised by view depth.
void aim(out vec3 origin, out vec3 ray) {
  vec2 point = viewPointOf(gl_FragCoord.xy - viewportOrigin, clipFromView, viewport, -1.0);
  vec3 aside = point.x * rightAndLength.xyz + point.y * upAndScale.xyz;
  bool perspective = clipFromView[2][3] != 0.0;
  origin = squeezed(perspective ? eyeAndGrowth.xyz : eyeAndGrowth.xyz + aside);
  ray = squeezed(perspective ? aside - backInFrame() : -backInFrame());
  // A view ray parallel to the light has no direction across it; any direction will do.
  if (dot(ray.xy, ray.xy) < 1e-12 * dot(ray, ray)) ray.x += 1e-6 * length(ray);
}

#ifdef SILHOUETTE
bool crossSilhouette(inout vec2 stretch, vec2 direction, float offset);
#endif

void main() {
  vec3 origin, ray;
  aim(origin, ray);
  // The projection of the ray from the light onto the plane of the discs.
  float scale = scaleAt(origin.z);
  float growth = eyeAndGrowth.w * ray.z;
  vec2 line = ray.xy * scale - origin.xy * growth;
  float inverse = inversesqrt(max(dot(line, line), 1e-24));
  vec2 direction = line * inverse;
  float offset = (ray.x * origin.y - ray.y * origin.x) * inverse;

  vec2 stretch = vec2(FAR, -FAR);
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    pass(stretch, discs[ i ], direction, offset);
  }
  #pragma unroll_loop_end
#ifdef SILHOUETTE
  if (stretch.x > stretch.y || !crossSilhouette(stretch, direction, offset)) discard;
#endif

  // Convert to depths along the ray. Under a lamp, the projected line ends where the ray points straight away from the
  // lamp.
  vec2 sinking = dot(ray.xy, direction) - stretch * growth;
  vec2 depths = (stretch * scale - dot(origin.xy, direction)) / sinking;
  if (sinking.x <= 0.0) depths.x = growth > 0.0 ? FAR : -FAR;
  if (sinking.y <= 0.0) depths.y = growth > 0.0 ? FAR : -FAR;
  vec2 ends = vec2(-origin.z, rightAndLength.w - origin.z) / (abs(ray.z) > 1e-9 ? ray.z : 1e-9);
  float enter = max(depths.x, min(ends.x, ends.y));
  float leave = min(depths.y, max(ends.x, ends.y));
  if (enter >= leave || leave <= near) discard;
  float depth = gl_FrontFacing ? max(enter, near) : leave;
  mat4 straight = withoutSlant(gl_FragCoord.xy - viewportOrigin, clipFromView, viewport);
  gl_FragDepth = clamp(windowDepth(straight, -depth), 0.0, 1.0);
}
