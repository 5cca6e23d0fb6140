precision highp float;
precision highp int;

// A soft sprite, blended over the finished picture with premultiplied alpha. It fades out close to surfaces behind it,
// by comparison with the depth texture (Lorach, 'Soft Particles', 2007).
uniform sampler2D ramps;
uniform sampler2D depth;
uniform mat4 clipFromView;

in vec2 puffPoint;
flat in vec3 depthRadiusFade;
flat in float material;

out vec4 pixel;

#include ../lib/depth.glsl
#include ../lib/attributes.glsl
#include ../lib/material.glsl

// Alpha at the centre of a sprite at birth.
const float DENSEST = 0.5;

void main() {
  float away = dot(puffPoint, puffPoint);
  if (away >= 1.0) discard;
  float behind = -viewZOf(clipFromView, texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r);
  float gap = clamp((behind - depthRadiusFade.x) / depthRadiusFade.y, 0.0, 1.0);
  float alpha = DENSEST * (1.0 - away) * (1.0 - away) * depthRadiusFade.z * gap;
  pixel = vec4(brightestOf(material, ramps) * alpha, alpha);
}
