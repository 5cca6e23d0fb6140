precision highp float;

// 1 where something stands between the light and what a pixel shows, by a depth map drawn from the light.
uniform sampler2D depth;
uniform sampler2D lightDepth;
uniform mat4 clipFromView;
uniform mat4 lightClipFromView;
uniform mat4 lightViewFromView;
uniform vec2 viewport;
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
  vec2 ndc = (lightClipFromView * vec4(seenByLight, 1.0)).xy;
  float nearest = -viewZOf(lightClipFromView, texture(lightDepth, 0.5 + 0.5 * ndc).r);
  bool inMap = all(lessThan(abs(ndc), vec2(1.0)));
  shadowed = vec4(own < 1.0 && inMap && -seenByLight.z > nearest + bias ? 1.0 : 0.0);
}
