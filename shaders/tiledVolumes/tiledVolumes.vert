precision highp float;
precision highp int;
precision highp sampler2DArray;

// A shadow volume of lib/volume.glsl: a quad covers its projection, at the depth of its nearest point. A volume that covers
// much of the picture has a quad for each tile instead, except for tiles without a receiver that it can contain.
uniform vec2 viewport;
// The row of each quad and the tile that it covers, four quads in a texel: see src/renderer/passes/tiledVolumes/volumeQuads.ts.
uniform highp usampler2D volumeQuads;
// The depths of depthRanges.frag.
uniform highp usampler2D depthRanges;

#include ../lib/rows.glsl
#include ../lib/depth.glsl
#include ../lib/pixel.glsl
#include ../lib/volume.glsl
#include ../lib/footprint.glsl

// Side of a tile, pixels.
const int DEPTH_TILE = 32;
// Bits of the number of a tile in an entry of volumeQuads; the other bits are the number of the row.
const int TILE_BITS = 15;
// Tile number of a quad that covers the whole volume.
const int WHOLE = (1 << TILE_BITS) - 1;
// Rounding, in puff radii.
const float SLACK = 1e-3;

// Corners of a box around the receivers of a tile, in the frame of the volume, as seen from the light on the plane of the
// discs. Returns false if they are on both sides of the light.
bool boundReceivers(ivec2 tile, vec2 depths, out vec3 low, out vec3 high) {
  low = vec3(1e9);
  high = vec3(-1e9);
  for (int i = 0; i < 8; i++) {
    float z = viewZOf(clipFromView, i < 4 ? depths.x : depths.y);
    vec2 pixel = vec2(DEPTH_TILE * (tile + ivec2(i & 1, (i >> 1) & 1)));
    vec3 seen = inFrame(vec3(viewPointOf(pixel, clipFromView, viewport, z), z));
    float scale = scaleAt(seen.z);
    if (scale <= 0.0) return false;
    seen.xy /= scale;
    low = min(low, seen);
    high = max(high, seen);
  }
  low -= SLACK;
  high += SLACK;
  return true;
}

bool reaches(vec3 disc, vec3 low, vec3 high) {
  vec2 beside = max(max(low.xy - disc.xy, disc.xy - high.xy), 0.0);
  return dot(beside, beside) < disc.z;
}

bool containsReceivers(ivec2 tile) {
  vec2 depths = uintBitsToFloat(texelFetch(depthRanges, tile, 0).rg);
  if (depths.x > depths.y) return false;
  vec3 low, high;
  if (!boundReceivers(tile, depths, low, high)) return true;
  bool isReached = false;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    isReached = isReached || reaches(discs[ i ], low, high);
  }
  #pragma unroll_loop_end
  return isReached && low.z <= rightAndLength.w && high.z >= 0.0;
}

void main() {
  int number = gl_VertexID / 4;
  int perLine = textureSize(volumeQuads, 0).x;
  int texel = number / 4;
  uint quad = texelFetch(volumeQuads, ivec2(texel % perLine, texel / perLine), 0)[number % 4];
  fetchRow(int(quad >> TILE_BITS));
  findCorner();
  int tileNumber = int(quad) & WHOLE;
  int columns = textureSize(depthRanges, 0).x;
  ivec2 tile = ivec2(tileNumber % columns, tileNumber / columns);
  Ends ends;
  if (!writeVolume(ends) || (tileNumber != WHOLE && !containsReceivers(tile))) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec2 pixel = float(DEPTH_TILE) * (vec2(tile) + 0.5 + 0.5 * corner);
  gl_Position = cornerAt(tileNumber == WHOLE ? footprint(corner, ends) : 2.0 * pixel / viewport - 1.0, ends);
}
