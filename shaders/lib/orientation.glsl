// Orientation of a lobe puff in the world: a rotation by its roll about an axis that its seed selects from 256, spread
// evenly over the sphere. Needs attributes.glsl.
mat3 worldFromPuff(uvec2 attributes) {
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
