precision highp float;
precision highp int;

// The second half of the smoothing, along columns, and the choice of a tone from the smoothed light. Output:
// display-encoded colour, not premultiplied. The gradient of a pixel is the factor between its colour and its ramp.
uniform sampler2D unlit;
uniform sampler2D lit;
uniform sampler2D shading;
uniform sampler2D ramps;
uniform vec3 deepShadow;
uniform vec3 rimColor;
uniform float litFrom;

out vec4 pixel;

#include ../lib/shading.glsl
#include ../lib/smoothing.glsl

const float RAMP_ROWS = 4.0;

vec3 rampAt(float material, float row, float facing) {
  float pitch = 1.0 / float(textureSize(ramps, 0).y);
  return textureLod(ramps, vec2(facing, (RAMP_ROWS * material + row + 0.5) * pitch), 0.0).rgb;
}

// The tone that the averaged fields select, without the gradient.
vec3 toneOf(vec4 light, float material) {
  if (light.r > 0.5) return rampAt(material, 1.0, max(light.g / light.r, litFrom));
  float darkness = light.b / (1.0 - light.r);
  vec3 shadow = rampAt(material, darkness > 0.75 ? 2.0 : 0.0, 0.0);
  return darkness < 0.25 ? shadow * deepShadow : shadow;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 shadowed = texelFetch(unlit, at, 0);
  vec4 direct = texelFetch(lit, at, 0);
  Shading own = unpackShading(texelFetch(shading, at, 0));
  vec4 light = smoothedAt(at, ivec2(0, 1), 2);
  if (own.radius == 0.0 || own.isInk) {
    vec3 shadow = light.b < 0.25 * (1.0 - light.r) ? shadowed.rgb * deepShadow : shadowed.rgb;
    pixel = vec4(light.r > 0.5 ? direct.rgb : shadow, shadowed.a);
    return;
  }
  if (light.a > 0.5) {
    pixel = vec4(rimColor, shadowed.a);
    return;
  }
  vec3 plain = rampAt(own.material, own.isFilled ? 2.0 : 0.0, own.facing);
  vec3 gradient = shadowed.rgb / max(plain, 1.0 / 255.0);
  pixel = vec4(min(toneOf(light, own.material) * gradient, 1.0), shadowed.a);
}
