// The linear map from a lobe puff to the world.
// DEFORMED: puffs turn and stretch with the air, and unfold.

// A rotation by its roll about an axis that its seed selects from 256, spread
// evenly over the sphere. Needs attributes.glsl.
mat3 rollOfPuff(uvec4 attributes) {
  const float SEEDS = 256.0;
  const float GOLDEN_ANGLE = 2.399963229728653;
  float seed = float(seedOf(attributes));
  float z = 1.0 - (2.0 * seed + 1.0) / SEEDS;
  vec3 axis = vec3(sqrt(1.0 - z * z) * vec2(cos(seed * GOLDEN_ANGLE), sin(seed * GOLDEN_ANGLE)), z);
  float c = cos(rollOf(attributes));
  vec3 s = sin(rollOf(attributes)) * axis;
  vec3 t = (1.0 - c) * axis;
  return mat3(
    t.x * axis + vec3(c, s.z, -s.y),
    t.y * axis + vec3(-s.z, c, s.x),
    t.z * axis + vec3(s.y, -s.x, c)
  );
}

#ifdef DEFORMED
uniform float billow;

#include stretch.glsl

// Factor on the centre of a lobe at an age, a fraction of the lifetime. Lobes of a young puff are folded to its centre and
// unfold one after another over the first half of life.
float unfolded(int index, float age) {
  const float BILLOW_DEPTH = 0.6;
  const float BILLOW_DELAY = 0.5;
  const float BILLOW_STEP = 0.618034;
  float phase = fract(float(index) * BILLOW_STEP);
  return 1.0 - BILLOW_DEPTH * billow * (1.0 - smoothstep(BILLOW_DELAY * phase, BILLOW_DELAY * phase + 1.0 - BILLOW_DELAY, 2.0 * age));
}

// Lobes become ellipsoids, longer by the ratio of the stretch along its axis than across it. Seen across it, they keep their area.
mat3 worldFromPuff(uvec4 attributes) {
  vec4 q = quaternionOf(attributes);
  mat3 rotation = mat3(
    1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.z * q.w), 2.0 * (q.x * q.z - q.y * q.w),
    2.0 * (q.x * q.y - q.z * q.w), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.x * q.w),
    2.0 * (q.x * q.z + q.y * q.w), 2.0 * (q.y * q.z - q.x * q.w), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)
  );
  vec4 stretch = stretchOf(attributes.w);
  vec3 a = stretch.xyz;
  vec3 along = (stretch.w - 1.0) * a;
  mat3 stretching = mat3(1.0) + mat3(along * a.x, along * a.y, along * a.z);
  return acrossOf(stretch.w) * stretching * rotation * rollOfPuff(attributes);
}
#else
mat3 worldFromPuff(uvec4 attributes) {
  return rollOfPuff(attributes);
}
#endif
