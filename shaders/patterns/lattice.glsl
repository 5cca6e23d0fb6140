// Marks that keep their size on screen, on lattices whose pitch is a power of two: each lattice contains the next coarser one, so
// that marks appear one after another. The idea is that of runevision, 'Dither3D' (2025). A place is on a plane; its gradient
// has the changes of the place for a pixel to the right and for one up.
// Distance of marks, and the width of their soft edge, pixels.
uniform float pitchPixels;
uniform float softnessPixels;

const float PI = 3.14159265359;

// Share of a pixel that is inside of an edge. @param inside distance to the edge, pixels
float coverOf(float inside) {
  return clamp(inside / (1.0 + softnessPixels) + 0.5, 0.0, 1.0);
}

#ifdef ON_BACKDROP
// Part of a radius that the roll of a full turn of the camera is a multiple of.
uniform float rollPart;

// The backdrop has one scale, so that its lattice needs one level. Its pitch divides the roll of a full turn, so that the pattern
// joins itself.
vec2 levelOf(float perPixel) {
  return vec2(rollPart / max(round(rollPart / (pitchPixels * perPixel)), 1.0), 0.0);
}
#else
// The pitch of the coarser lattice, and how far the finer one with half its pitch has grown, 0..1.
// @param perPixel change of the place for a pixel
vec2 levelOf(float perPixel) {
  float level = log2(pitchPixels * max(perPixel, 1e-9));
  float coarse = ceil(level);
  return vec2(exp2(coarse), coarse - level);
}
#endif

// Share of a line that covers `amount` of the plane. @param height coordinate across the lines, @param slope its gradient
float lineAt(float height, vec2 slope, float amount) {
  float perPixel = length(slope);
  vec2 level = levelOf(perPixel);
  float grown = smoothstep(0.0, 1.0, level.y);
  float pixels = level.x / max(perPixel, 1e-9);
  float whole = amount * pixels / (1.0 + grown);
  float position = height / level.x;
  float away = abs(position - floor(position + 0.5)) * pixels;
  float between = abs(fract(position) - 0.5) * pixels;
  // Lines that are thinner than a pixel are lighter instead.
  float first = coverOf(0.5 * max(whole, 1.0) - away) * min(whole, 1.0);
  float second = coverOf(0.5 * max(whole * grown, 1.0) - between) * min(whole * grown, 1.0);
  return max(first, second);
}
