// The depth of the smoke in the finished depth of the picture. Needs depth.glsl.
uniform highp sampler2D depth;
// Copy of the depth of the surfaces.
uniform highp sampler2D surfaceDepth;
uniform bool hasSurfaces;

const float NOWHERE = -1e9;
const float NO_SMOKE = -1e8;

// View z of the smoke at a pixel; below NO_SMOKE if it shows something else.
float smokeZ(mat4 clipFromView, vec2 pixel) {
  ivec2 at = clamp(ivec2(floor(pixel)), ivec2(0), textureSize(depth, 0) - 1);
  float here = texelFetch(depth, at, 0).r;
  float empty = depthOrder(clipFromView) < 0.0 ? 0.0 : 1.0;
  if (here == empty || (hasSurfaces && here == texelFetch(surfaceDepth, at, 0).r)) return NOWHERE;
  return viewZOf(clipFromView, here);
}
