precision highp float;

// The shadow volume of a closed mesh: every face has its own copy of its corners, faces that look away from the light
// are carried along it, and the strips that join neighbouring faces open into the sides.
uniform mat4 modelMatrix;
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec4 lightInWorld;
uniform vec3 receiversMin;
uniform vec3 receiversMax;
uniform float inset;
uniform float longestEdge;

in vec3 position;
in vec3 faceNormal;

#include ../lib/box.glsl
#include ../lib/light.glsl

// Between two corners the way out of a box can be longer than at both; no triangle is so long that this falls short, metres.
const float MARGIN = 0.1;

// The rays of a lamp part by the length of an edge for each of its distances from the lamp, but hardly by more than this.
const float WIDEST = 0.5;

float extentOf(vec3 world, vec3 travel) {
  float growth = lightInWorld.w * min(WIDEST, longestEdge / max(length(world - lightInWorld.xyz), 1e-6));
  return exitFromBox(world, travel, receiversMin, receiversMax, MARGIN, growth);
}

void main() {
  vec3 world = (modelMatrix * vec4(position, 1.0)).xyz;
  vec3 travel = -towardsLightFrom(lightInWorld, world);
  bool facesLight = dot(mat3(modelMatrix) * faceNormal, travel) < 0.0;
  // The inset sinks the start under the lit faces, which would otherwise fight their own volume for depth.
  world += travel * (facesLight ? inset : max(extentOf(world, travel), inset));
  gl_Position = clipFromView * viewFromWorld * vec4(world, 1.0);
}
