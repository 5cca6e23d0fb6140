// What is averaged of a pixel, see fieldOf and shading.glsl, and bits of the neighbours that may be averaged with it.
struct PackedField {
  vec4 field;
  int links;
#ifdef ADDITIONAL_LIGHTS
  int lights;
#endif
};

const int LINKED_RIGHT = 1;
const int LINKED_ABOVE = 2;
// The lowest bit of the set of lights.
const int FIRST_LIGHT = 4;
// The share of rim of one pixel, 0 or 1, in the alpha of a texel.
const int IS_RIM = 128;

vec4 packField(PackedField here) {
  int bits = here.links + (here.field.a > 0.5 ? IS_RIM : 0);
#ifdef ADDITIONAL_LIGHTS
  bits += FIRST_LIGHT * here.lights;
#endif
  return vec4(here.field.rgb, float(bits) / 255.0);
}

PackedField unpackField(vec4 texel) {
  int bits = int(255.0 * texel.a + 0.5);
  vec4 field = vec4(texel.rgb, bits >= IS_RIM ? 1.0 : 0.0);
#ifdef ADDITIONAL_LIGHTS
  return PackedField(field, bits, bits / FIRST_LIGHT & 7);
#else
  return PackedField(field, bits);
#endif
}
