// The law of a puff's line: how wide it is and how much of it is ink. Widths and radii are in pixels of the target.

// A line keeps its width beside puffs with a radius of 3.5 widths and more. Beside smaller ones it narrows, and a puff
// no larger than the line is wide has none: far smoke stays smoke and does not turn into dots. The billboards' layers
// end 0.3 radii beyond the silhouette, and this is no more.
float lineWidth(float fullWidth, float radius) {
  return fullWidth * smoothstep(1.0, 3.5, radius / max(fullWidth, 1e-6));
}

// How far from its even width a line is where it runs along the side that looks in `outward`, a unit vector of the image
// plane: with a swell of 1 twice as wide away from the light, half as wide towards it, and even under a light from the eye.
float swelling(vec2 outward, vec3 towardsLightInView, float swell) {
  return exp2(-swell * dot(outward, towardsLightInView.xy));
}

// What sets the line of one puff in one drawing apart from all others, 0 to 2 pi.
float boilPhase(int seed, int drawing) {
  uint bits = uint(seed) * 747796405u + uint(drawing) * 2891336453u;
  bits = (bits ^ (bits >> 16u)) * 73244475u;
  return float((bits >> 8u) & 0xffffu) * (6.28318530718 / 65536.0);
}

// Share of its width that an unsteady hand leaves of a line, by where round the puff it runs: down to a half where the
// boil is 1. Never more than all, so that quads and volumes stay what they are.
float boiling(vec2 outward, float phase, float boil) {
  if (boil <= 0.0) return 1.0;
  float angle = atan(outward.y, outward.x);
  return 1.0 - boil * (0.25 + 0.125 * (sin(3.0 * angle + phase) + sin(8.0 * angle - 2.7 * phase)));
}

// How much of a line is ink and how much the colour of its smoke. Under a pixel a line would break into dots. Beside a
// puff that dies it pales from a radius of three full widths on, over many pictures: it would go at once if only its
// width told it to.
float inkShare(float width, float fullWidth, float radius) {
  return smoothstep(0.5, 1.0, width) * smoothstep(1.5, 3.0, radius / max(fullWidth, 1e-6));
}

// How much deeper than at the silhouette a line lies `outside` pixels beyond it: the farther out the deeper, so that a
// line between two puffs grows with the gap and does not come at once. Its first pixel goes as one, for a line that
// thins to less would end in dots.
float sinking(float outside, float width, float taper) {
  return 1.0 + taper * clamp(max(outside, 1.0) / max(width, 1e-6), 0.0, 1.0);
}
