// Unpacks the four words of a row's attributes, which the simulator packs in arrange.
float rollOf(uvec4 attributes) {
  return float(attributes.x & 0xffffu) * (6.28318530718 / 65536.0);
}

// Age as a fraction of the lifetime.
float ageOf(uvec4 attributes) {
  return float(attributes.x >> 16u) / 65535.0;
}

// Replaces the age in rows of casters: distance behind the centre, in radii, at which the shadow may end because other
// shadows continue it or no receiver is left.
float endOf(uvec4 attributes) {
  uint end = attributes.x >> 16u;
  return end == 0xffffu ? 1e9 : float(end) / 256.0;
}

// The same in rows of casters.
float casterAgeOf(uvec4 attributes) {
  return float(attributes.y >> 16u) / 65535.0;
}

int variationOf(uvec4 attributes) {
  return int(attributes.y & 0xffu);
}

int seedOf(uvec4 attributes) {
  return int((attributes.y >> 8u) & 0xffu);
}

// 0 for no tint, else 1 to 15.
int tintOf(uvec4 attributes) {
  return int((attributes.y >> 24u) & 0xfu);
}

// Turn by the air as a unit quaternion x, y, z, w: the three components after the largest one are packed.
vec4 quaternionOf(uvec4 attributes) {
  const float QUATERNION_STEPS = 720.0;
  const uint NO_ROTATION = 0xe0080200u;
  uint word = attributes.z ^ NO_ROTATION;
  vec3 rest = (vec3(uvec3(word, word >> 10u, word >> 20u) & 0x3ffu) - 512.0) / QUATERNION_STEPS;
  float largest = sqrt(max(0.0, 1.0 - dot(rest, rest)));
  uint index = word >> 30u;
  if (index == 0u) return vec4(largest, rest);
  if (index == 1u) return vec4(rest.z, largest, rest.xy);
  return index == 2u ? vec4(rest.yz, largest, rest.x) : vec4(rest, largest);
}

// Direction of the stretch, a unit vector, and the ratio of the axes, 1 and up; by the last word.
vec4 stretchOf(uint word) {
  const float MAX_STRETCH = 4.0;
  vec2 map = (vec2(uvec2(word, word >> 8u) & 0xffu) - 127.0) / 127.0;
  float z = 1.0 - abs(map.x) - abs(map.y);
  vec2 signs = vec2(map.x < 0.0 ? -1.0 : 1.0, map.y < 0.0 ? -1.0 : 1.0);
  vec2 xy = z < 0.0 ? (1.0 - abs(map.yx)) * signs : map;
  float ratio = 1.0 + (MAX_STRETCH - 1.0) * float((word >> 16u) & 0xffu) / 255.0;
  return vec4(normalize(vec3(xy, z)), ratio);
}

// Ramp index of a tint: 0 without a tint, else one of the tint ramps in rotation.
int toneOf(uvec4 attributes) {
  const int TINTS = 3;
  int tint = tintOf(attributes);
  return tint == 0 ? 0 : 1 + (tint - 1) % TINTS;
}
