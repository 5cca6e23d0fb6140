// Ramp index of a puff, see src/renderer/gpu/ramps.ts: by its tint, else by its age and temperature. Needs attributes.glsl.
float materialOf(uvec4 attributes, sampler2D ramps) {
  int tone = toneOf(attributes);
  if (tone > 0) return float(tone);
  int bands = textureSize(ramps, 0).y - 1;
  vec2 age = texelFetch(ramps, ivec2(int(attributes.x >> 24u), bands), 0).rg;
  vec2 heat = texelFetch(ramps, ivec2(int((attributes.y >> 16u) & 0xffu), bands), 0).ba;
  return floor(dot(age + heat, vec2(255.0, 65280.0)) + 0.5);
}
