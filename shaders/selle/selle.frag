precision highp float;
precision highp int;
precision highp sampler2DArray;

// One flat colour inside the silhouette of a puff. The alpha of the lit colour marks smoke for lines.frag.
uniform sampler2DArray colorCoverage;
uniform sampler2D ramps;
uniform float pad;

in vec2 puffPoint;
flat in int variation;
flat in float material;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

const int RAMP_TEXELS = 256;
const int RAMP_ROWS = 4;
#ifdef LOOKS
float withoutLook(float rampIndex);
ivec2 inColumns(ivec2 texel);
#endif

void main() {
  vec3 layerPoint = vec3(0.5 + 0.5 * puffPoint / pad, float(variation % textureSize(colorCoverage, 0).z));
  if (texture(colorCoverage, layerPoint).a > 0.5) discard;
  // In full light.
#ifdef LOOKS
  ivec2 texel = inColumns(ivec2(RAMP_TEXELS - 1, RAMP_ROWS * int(withoutLook(material)) + 1));
#else
  ivec2 texel = ivec2(RAMP_TEXELS - 1, RAMP_ROWS * int(material) + 1);
#endif
  vec3 color = texelFetch(ramps, texel, 0).rgb;
  unlit = vec4(color, 1.0);
  lit = vec4(color, 1.0);
}
