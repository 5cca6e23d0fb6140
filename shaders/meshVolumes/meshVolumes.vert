precision highp float;

// The shadow volume of a closed mesh: every face has its own copy of its corners, faces that look away from the light
// are carried along it, and the strips that join neighbouring faces open into the sides.
uniform mat4 modelMatrix;
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec3 travelInWorld;
uniform vec3 receiversMin;
uniform vec3 receiversMax;
uniform float inset;

in vec3 position;
in vec3 faceNormal;

#include ../lib/box.glsl

// Between two corners the way out of a box can be longer than at both; no triangle is so long that this falls short, metres.
const float MARGIN = 0.1;

void main() {
  vec3 world = (modelMatrix * vec4(position, 1.0)).xyz;
  bool facesLight = dot(mat3(modelMatrix) * faceNormal, travelInWorld) < 0.0;
  // The inset sinks the start under the lit faces, which would otherwise fight their own volume for depth.
  float extent = exitFromBox(world, travelInWorld, receiversMin, receiversMax, MARGIN);
  world += travelInWorld * (facesLight ? inset : max(extent, inset));
  gl_Position = clipFromView * viewFromWorld * vec4(world, 1.0);
}
