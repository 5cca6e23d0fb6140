precision highp float;

// A mesh of the scene. Inputs are in model space; outputs are the normal and the position in world space.
uniform mat4 modelMatrix;
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;

in vec3 position;
in vec3 normal;

out vec3 worldNormal;
out vec3 worldPlace;

void main() {
  worldNormal = mat3(modelMatrix) * normal;
  worldPlace = (modelMatrix * vec4(position, 1.0)).xyz;
  gl_Position = clipFromView * viewFromWorld * modelMatrix * vec4(position, 1.0);
}
