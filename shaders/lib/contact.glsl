// Ink where smoke touches a surface. The ring of ink is deeper than its puff and would sink into the floor under the
// puff, so it is lifted to the surface here. Where a puff intersects a surface, its line follows the seam. Needs
// depth.glsl.
uniform highp sampler2D surfaceDepth;
uniform bool hasSurfaces;
// Distance from the pixel centre, in pixels, at which the surface depth is evaluated in a multisampled framebuffer;
// else 0.
uniform float surfaceSlack;

// Distance of a lifted ring in front of the surface, in steps of a 24-bit depth buffer.
const float LIFT_STEPS = 3.0;
const float LIFT = LIFT_STEPS / 16777216.0;
// Steepest slope towards the camera, per unit beside the silhouette, at which a surface still counts as behind the
// puff.
const float STEEPEST = 8.0;
// Least z of a normal for the slope of a puff. Close to the silhouette puffs are so steep that the slope is meaningless.
const float FLATTEST = 0.1;

// Window depth and view z of the surface in this pixel. The z is beyond everything if there is none.
vec2 surfaceHere(mat4 clipFromView) {
  const float NOTHING = -1e9;
  float depth = texelFetch(surfaceDepth, ivec2(gl_FragCoord.xy), 0).r;
  return vec2(depth, hasSurfaces ? viewZOf(clipFromView, depth) : NOTHING);
}

// Difference of the surface's window depth between neighbouring pixels along an axis. Across an edge, the flatter side
// counts.
float depthStep(float here, ivec2 axis) {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float ahead = abs(texelFetch(surfaceDepth, at + axis, 0).r - here);
  float behind = abs(texelFetch(surfaceDepth, at - axis, 0).r - here);
  return min(ahead, behind);
}

// How much nearer than at its centre the surface may be within this pixel.
float lift(float here) {
  if (surfaceSlack == 0.0) return LIFT;
  return LIFT + surfaceSlack * (depthStep(here, ivec2(1, 0)) + depthStep(here, ivec2(0, 1)));
}

// Window depth of a ring of ink with view z `sunkenZ`. If the surface is behind the puff at the silhouette, `inward`
// pixels away, the ring is in front of the surface. `here` is that of surfaceHere.
float ringDepth(mat4 clipFromView, vec2 here, float rimZ, float sunkenZ, float outside, vec2 inward) {
  float depth = windowDepth(clipFromView, sunkenZ);
  ivec2 last = textureSize(surfaceDepth, 0) - 1;
  float atRim = texelFetch(surfaceDepth, clamp(ivec2(gl_FragCoord.xy + inward), ivec2(0), last), 0).r;
  bool isBefore = viewZOf(clipFromView, atRim) < rimZ;
  bool isSlope = here.y < rimZ + STEEPEST * outside;
  float order = depthOrder(clipFromView);
  return hasSurfaces && isBefore && isSlope ? order * min(order * depth, order * here.x - lift(here.x)) : depth;
}

// Difference of the surface's view z between neighbouring pixels along an axis. Across an edge, the side of this pixel
// counts.
float slopeOfSurface(mat4 clipFromView, float here, ivec2 axis) {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float ahead = viewZOf(clipFromView, texelFetch(surfaceDepth, at + axis, 0).r) - here;
  float behind = here - viewZOf(clipFromView, texelFetch(surfaceDepth, at - axis, 0).r);
  return abs(ahead) < abs(behind) ? ahead : behind;
}

// Whether a point of a puff is within `reach` pixels of the seam where the puff intersects the surface with view z `here`.
// `pixel` is the size of a pixel in view units.
bool isSeam(mat4 clipFromView, float here, float viewZ, vec3 normal, float pixel, float reach) {
  if (!hasSurfaces || reach <= 0.0) return false;
  float gap = viewZ - here;
  if (gap > (STEEPEST + 1.0 / FLATTEST) * reach * pixel) return false;
  vec2 slope = -normal.xy / max(normal.z, FLATTEST) * pixel;
  slope -= vec2(
    slopeOfSurface(clipFromView, here, ivec2(1, 0)),
    slopeOfSurface(clipFromView, here, ivec2(0, 1))
  );
  return gap < reach * length(slope);
}
