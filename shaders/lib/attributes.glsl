// Unpacks the two words of a row's attributes, which the simulator packs in arrange.
float rollOf(uvec2 attributes) {
  return float(attributes.x & 0xffffu) * (6.28318530718 / 65536.0);
}

// Age as a fraction of the lifetime.
float ageOf(uvec2 attributes) {
  return float(attributes.x >> 16u) / 65535.0;
}

// Replaces the age in rows of casters: distance behind the centre, in radii, at which the shadow may end because other
// shadows continue it or no receiver is left.
float endOf(uvec2 attributes) {
  uint end = attributes.x >> 16u;
  return end == 0xffffu ? 1e9 : float(end) / 256.0;
}

int variationOf(uvec2 attributes) {
  return int(attributes.y & 0xffu);
}

int seedOf(uvec2 attributes) {
  return int((attributes.y >> 8u) & 0xffu);
}

// 0 for no tint, else 1 to 15.
int tintOf(uvec2 attributes) {
  return int(attributes.y >> 24u);
}

// Ramp index of a tint: 0 without a tint, else one of the tint ramps in rotation.
int toneOf(uvec2 attributes) {
  const int TINTS = 3;
  int tint = tintOf(attributes);
  return tint == 0 ? 0 : 1 + (tint - 1) % TINTS;
}
