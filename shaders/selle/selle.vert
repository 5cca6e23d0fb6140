precision highp float;
precision highp int;
precision highp sampler2DArray;

// A puff as Selle, Mohr and Chenney drew it (2004): a flat picture parallel to the image plane, at one depth.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform sampler2D ramps;
uniform sampler2DArray colorCoverage;

in vec2 corner;
in vec4 place;
in uvec2 look;

out vec2 puffPoint;
flat out int variation;
flat out float material;

#include ../lib/look.glsl
#include ../lib/material.glsl

void main() {
  vec2 turn = vec2(cos(rollOf(look)), sin(rollOf(look)));
  puffPoint = vec2(turn.x * corner.x + turn.y * corner.y, turn.x * corner.y - turn.y * corner.x);
  variation = variationOf(look) % textureSize(colorCoverage, 0).z;
  material = materialOf(look, ramps);
  vec3 centre = (viewFromWorld * vec4(place.xyz, 1.0)).xyz;
  gl_Position = clipFromView * vec4(centre + vec3(corner * place.w, 0.0), 1.0);
}
