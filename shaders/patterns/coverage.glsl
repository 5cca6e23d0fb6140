// Added to the shaders of the last step: draws the marks of the pattern beneath ink, by the share of the pixel that they cover.
uniform sampler2D coverage;
uniform vec3 patternColor;

// @param color premultiplied and display-encoded
vec4 withMarks(vec4 color, ivec2 at) {
  float covered = texelFetch(coverage, at, 0).r;
  if (covered == 0.0) return color;
  vec3 own = color.rgb / max(color.a, 1e-3);
  vec3 mixed = displayFromLinear(mix(linearFromDisplay(own), linearFromDisplay(patternColor), covered));
  return vec4(mixed * color.a, color.a);
}
