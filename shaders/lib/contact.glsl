// Ink where smoke touches a surface. A ring that lies deeper than its puff sinks into the floor on which the puff rests,
// so here it is lifted out again, and where a puff dips into a surface its line runs along the seam. Needs depth.glsl.
uniform highp sampler2D surfaceDepth;
uniform bool hasSurfaces;
// Pixels about its middle of which a pixel's surface is tested, where the picture is smoothed; else 0.
uniform float surfaceSlack;

// Steps of a 24-bit depth buffer by which a lifted ring stays before its surface.
const float LIFT = 3.0 / 16777216.0;
// A surface may come nearer by so much for each unit beside the silhouette and is still what lies behind the puff.
const float STEEPEST = 8.0;

// View z of the surface in this pixel, beyond everything where there is none.
float surfaceZ(mat4 clipFromView) {
  const float NOTHING = -1e9;
  return hasSurfaces ? viewZOf(clipFromView, texelFetch(surfaceDepth, ivec2(gl_FragCoord.xy), 0).r) : NOTHING;
}

// The step of the surface's window depth from pixel to pixel along an axis; across an edge, that of its flatter side.
float depthStep(float here, ivec2 axis) {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float ahead = abs(texelFetch(surfaceDepth, at + axis, 0).r - here);
  float behind = abs(texelFetch(surfaceDepth, at - axis, 0).r - here);
  return min(ahead, behind);
}

// How much nearer than in the middle the surface may be within this pixel.
float lift(float here) {
  if (surfaceSlack == 0.0) return LIFT;
  return LIFT + surfaceSlack * (depthStep(here, ivec2(1, 0)) + depthStep(here, ivec2(0, 1)));
}

// Window depth of a ring of ink that would lie at `sunkenZ`. Where the surface lies behind the puff at the silhouette,
// `inward` pixels away, the ring lies before the surface.
float ringDepth(mat4 clipFromView, float rimZ, float sunkenZ, float outside, vec2 inward) {
  float depth = windowDepth(clipFromView, sunkenZ);
  if (!hasSurfaces) return depth;
  ivec2 last = textureSize(surfaceDepth, 0) - 1;
  float here = texelFetch(surfaceDepth, ivec2(gl_FragCoord.xy), 0).r;
  float atRim = texelFetch(surfaceDepth, clamp(ivec2(gl_FragCoord.xy + inward), ivec2(0), last), 0).r;
  float order = depthOrder(clipFromView);
  bool isBefore = order * (atRim - windowDepth(clipFromView, rimZ)) > 0.0;
  bool isSlope = order * (here - windowDepth(clipFromView, rimZ + STEEPEST * outside)) > 0.0;
  return isBefore && isSlope ? order * min(order * depth, order * here - lift(here)) : depth;
}

// The step of the surface's view z from pixel to pixel along an axis; across an edge, that of its own side.
float slopeOfSurface(mat4 clipFromView, float here, ivec2 axis) {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float ahead = viewZOf(clipFromView, texelFetch(surfaceDepth, at + axis, 0).r) - here;
  float behind = here - viewZOf(clipFromView, texelFetch(surfaceDepth, at - axis, 0).r);
  return abs(ahead) < abs(behind) ? ahead : behind;
}

// Whether a point of a puff lies within `reach` pixels of the seam along which the puff dips into a surface. `pixel` are
// the view units that one spans.
bool isSeam(mat4 clipFromView, float viewZ, vec3 normal, float pixel, float reach) {
  // Beside the silhouette puffs turn away so steeply that a slope says nothing.
  const float FLATTEST = 0.1;
  if (!hasSurfaces || reach <= 0.0) return false;
  float here = surfaceZ(clipFromView);
  float gap = viewZ - here;
  if (gap > (STEEPEST + 1.0 / FLATTEST) * reach * pixel) return false;
  vec2 slope = -normal.xy / max(normal.z, FLATTEST) * pixel;
  slope -= vec2(
    slopeOfSurface(clipFromView, here, ivec2(1, 0)),
    slopeOfSurface(clipFromView, here, ivec2(0, 1))
  );
  return gap < reach * length(slope);
}
