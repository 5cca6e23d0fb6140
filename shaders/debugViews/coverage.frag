precision highp float;

// The lit colours, dimmed, with the grid of the occlusion culling on top: grid lines, and a tint on covered cells,
// bright for near depths and dark for far ones. Screen space.
uniform sampler2D lit;
uniform mat4 clipFromView;
// View depths between which the tint fades.
uniform vec2 depthRange;
// View depths behind which nothing is visible; larger than FARTHEST for uncovered cells.
uniform sampler2D grid;
uniform ivec2 gridCells;
// Lower left corner on the image plane at unit depth, and cells for each unit of that plane.
uniform vec3 gridPlace;

out vec4 pixel;

const vec3 TINT = vec3(1.0, 0.55, 0.1);
const float FARTHEST = 1e20;

void main() {
  vec2 plane = (2.0 * gl_FragCoord.xy / vec2(textureSize(lit, 0)) - 1.0) / vec2(clipFromView[0][0], clipFromView[1][1]);
  vec2 place = (plane - gridPlace.xy) * gridPlace.z;
  ivec2 cell = ivec2(floor(place));
  vec3 color = 0.4 * texelFetch(lit, ivec2(gl_FragCoord.xy), 0).rgb;
  if (all(greaterThanEqual(cell, ivec2(0))) && all(lessThan(cell, gridCells))) {
    float away = (texelFetch(grid, cell, 0).r - depthRange.x) / (depthRange.y - depthRange.x);
    if (away < FARTHEST) color += 0.6 * TINT * clamp(1.0 - away, 0.25, 1.0);
    // The first pixel of a cell shows the grid line.
    vec2 width = gridPlace.z * 2.0 / vec2(textureSize(lit, 0)) / vec2(clipFromView[0][0], clipFromView[1][1]);
    if (any(lessThan(fract(place), width))) color *= 0.75;
  }
  pixel = vec4(color, 1.0);
}
