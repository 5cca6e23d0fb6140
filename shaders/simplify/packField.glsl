// What is averaged of a pixel, see fieldOf, and bits of the neighbours that may be averaged with it.
struct PackedField {
  vec4 field;
  int links;
};

const int LINKED_RIGHT = 1;
const int LINKED_ABOVE = 2;
// The share of rim of one pixel, 0 or 1, in the alpha of a texel.
const int IS_RIM = 128;

vec4 packField(PackedField here) {
  return vec4(here.field.rgb, float(here.links + (here.field.a > 0.5 ? IS_RIM : 0)) / 255.0);
}

PackedField unpackField(vec4 texel) {
  int bits = int(255.0 * texel.a + 0.5);
  return PackedField(vec4(texel.rgb, bits >= IS_RIM ? 1.0 : 0.0), bits);
}
