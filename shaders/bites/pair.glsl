// Two radii in one number, because some GPUs have no more varyings.
const float PAIR_STEPS = 1024.0;

float pairOf(vec2 radii) {
  return floor(PAIR_STEPS * radii.x) + 0.5 * radii.y;
}

vec2 radiiOf(float pair) {
  return vec2(floor(pair) / PAIR_STEPS, 2.0 * fract(pair));
}
