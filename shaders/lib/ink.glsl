// Width and opacity of a puff's outline. Widths and radii are in pixels of the target.

// Radius of a puff in line widths, and width of a line in pixels, between which a line grows or fades.
const vec2 LINE_RADII = vec2(1.0, 3.5);
const vec2 FADE_WIDTHS = vec2(0.5, 1.0);
const vec2 FADE_RADII = vec2(1.5, 3.0);

#ifdef LOOKS
float inkWeightOf(float rampIndex);
#endif

// A line has its full width on puffs with a radius of at least 3.5 widths. On smaller puffs it narrows, and a puff no
// larger than the line width has none, so that distant smoke does not turn into dots. The width is at most 0.301 radii,
// within the 0.35 radii by which billboard layers extend beyond the silhouette.
float lineWidth(float fullWidth, float radius) {
  return fullWidth * smoothstep(LINE_RADII.x, LINE_RADII.y, radius / max(fullWidth, 1e-6));
}

// Factor on the width of a line where the silhouette faces `outward`, a unit vector of the image plane. With a swell of
// 1 it is up to 2 on the side away from the light and 1/2 towards it. Under a light from the camera it is 1.
float swelling(vec2 outward, vec3 towardsLightInView, float swell) {
  return exp2(-swell * dot(outward, towardsLightInView.xy));
}

// Phase of the boil of a puff's line in a drawing, 0 to 2 pi, hashed from both.
float boilPhase(int seed, int drawing) {
  uint bits = uint(seed) * 747796405u + uint(drawing) * 2891336453u;
  bits = (bits ^ (bits >> 16u)) * 73244475u;
  return float((bits >> 8u) & 0xffffu) * (6.28318530718 / 65536.0);
}

// Factor on the width of a boiling line by the direction around the puff: down to 1/2 where the boil is 1. It is never
// above 1, so the bounds of quads and volumes still hold.
float boiling(vec2 outward, float phase, float boil) {
  if (boil <= 0.0) return 1.0;
  float angle = atan(outward.y, outward.x);
  return 1.0 - boil * (0.25 + 0.125 * (sin(3.0 * angle + phase) + sin(8.0 * angle - 2.7 * phase)));
}

// Opacity of the ink over the colour of the smoke. Lines below one pixel would break up into dots. The line of a dying
// puff fades from a radius of three full widths over many frames; the width alone would make it vanish at once.
float inkShare(float width, float fullWidth, float radius) {
  float byWidth = smoothstep(FADE_WIDTHS.x, FADE_WIDTHS.y, width);
  return byWidth * smoothstep(FADE_RADII.x, FADE_RADII.y, radius / max(fullWidth, 1e-6));
}

// Factor on the depth offset of a line, `outside` pixels beyond the silhouette. The offset increases outwards, so that
// a line between two puffs widens with the depth gap instead of appearing at full width. The first pixel has one
// offset, because thinner lines would end in dots.
float sinking(float outside, float width, float taper) {
  return 1.0 + taper * clamp(max(outside, 1.0) / max(width, 1e-6), 0.0, 1.0);
}
