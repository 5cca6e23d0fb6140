// LOOKS: src/renderer/looks.ts adds looks/looks.glsl.
#ifdef LOOKS
int bandRowOf(uvec4 attributes, int rows);
float withLook(float material, uvec4 attributes);
#endif

// Ramp index of a puff, see src/renderer/gpu/ramps.ts: by its tint, else by its age and temperature. Needs attributes.glsl.
float materialOf(uvec4 attributes, sampler2D ramps) {
  float material = float(toneOf(attributes));
  if (material == 0.0) {
    int bands = textureSize(ramps, 0).y - 1;
#ifdef LOOKS
    bands = bandRowOf(attributes, bands + 1);
#endif
    vec2 age = texelFetch(ramps, ivec2(int(attributes.x >> 24u), bands), 0).rg;
    vec2 heat = texelFetch(ramps, ivec2(int((attributes.y >> 16u) & 0xffu), bands), 0).ba;
    material = floor(dot(age + heat, vec2(255.0, 65280.0)) + 0.5);
  }
#ifdef LOOKS
  material = withLook(material, attributes);
#endif
  return material;
}
