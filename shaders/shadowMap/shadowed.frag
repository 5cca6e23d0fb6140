precision highp float;

// Tests pixels against the depth map of the light (Williams 1978). Outputs 1 for pixels in shadow and 0 for lit ones;
// pixels outside the map are discarded.
uniform sampler2D depth;
uniform sampler2D lightDepth;
uniform mat4 clipFromView;
uniform mat4 lightClipFromView;
uniform mat4 lightViewFromView;
uniform vec2 viewport;
// Depth bias as a share of the width that the map covers at that depth.
uniform float bias;

out vec4 shadowed;

#include ../lib/depth.glsl

vec3 placeInView(vec2 ndc, float viewZ) {
  vec2 scale = vec2(clipFromView[0][0], clipFromView[1][1]);
  bool perspective = clipFromView[2][3] != 0.0;
  return vec3((perspective ? -viewZ * (ndc + clipFromView[2].xy) : ndc - clipFromView[3].xy) / scale, viewZ);
}

void main() {
  float own = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
  vec3 place = placeInView(gl_FragCoord.xy / viewport * 2.0 - 1.0, viewZOf(clipFromView, own));
  vec3 seenByLight = (lightViewFromView * vec4(place, 1.0)).xyz;
  vec4 clip = lightClipFromView * vec4(seenByLight, 1.0);
  if (own == 1.0 || any(greaterThan(abs(clip.xy), vec2(clip.w)))) discard;
  float nearest = -viewZOf(lightClipFromView, texture(lightDepth, 0.5 + 0.5 * clip.xy / clip.w).r);
  float width = 2.0 * clip.w / lightClipFromView[0][0];
  shadowed = vec4(-seenByLight.z > nearest + bias * width ? 1.0 : 0.0);
}
