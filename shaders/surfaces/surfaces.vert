precision highp float;

// The meshes of the scene. Inputs are in model space; outputs are the normal and the position in world space, the
// ramp index and the number of the group.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
// Ramp index of the first surface; the others follow in order.
uniform float firstMaterial;

in vec3 position;
in vec3 normal;
// Index of the surface, number of its group, and row of the transform.
in vec3 surfaceGroupRow;

out vec3 worldNormal;
out vec3 worldPlace;
flat out float material;
flat out float group;

#include ../lib/transforms.glsl

void main() {
  float surface = surfaceGroupRow.x;
  mat4 transform = worldFromModel(int(surfaceGroupRow.z));
  group = surfaceGroupRow.y;
  worldNormal = mat3(transform) * normal;
  worldPlace = (transform * vec4(position, 1.0)).xyz;
  material = firstMaterial + surface;
  gl_Position = clipFromView * viewFromWorld * transform * vec4(position, 1.0);
}
