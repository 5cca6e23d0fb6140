precision highp float;
precision highp int;

// The nearest and the farthest depth in each tile of the picture, one fragment for each tile. Pixels that show nothing are
// left out; a tile of only such pixels has a nearest depth beyond the farthest. Output: the bits of both depths. Integers,
// because not every GPU renders to floats.
uniform highp sampler2D depth;
uniform mat4 clipFromView;

layout(location = 0) out uvec2 range;

#include ../lib/depth.glsl
// Side of a tile, pixels.
const int DEPTH_TILE = 32;

void main() {
  ivec2 start = DEPTH_TILE * ivec2(gl_FragCoord.xy);
  ivec2 end = min(start + DEPTH_TILE, textureSize(depth, 0));
  float nothing = depthOrder(clipFromView) < 0.0 ? 0.0 : 1.0;
  float low = 1.0;
  float high = 0.0;
  for (int y = start.y; y < end.y; y++) {
    for (int x = start.x; x < end.x; x++) {
      float found = texelFetch(depth, ivec2(x, y), 0).r;
      if (found == nothing) continue;
      low = min(low, found);
      high = max(high, found);
    }
  }
  range = floatBitsToUint(vec2(low, high));
}
