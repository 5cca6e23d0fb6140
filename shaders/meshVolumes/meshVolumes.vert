precision highp float;

// The shadow volume of a closed mesh: every face has its own copy of its corners, faces that look away from the light
// are carried along it, and the strips that join neighbouring faces open into the sides.
uniform mat4 modelMatrix;
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec3 travelInWorld;
uniform float extent;
uniform float inset;

in vec3 position;
in vec3 faceNormal;

void main() {
  vec3 world = (modelMatrix * vec4(position, 1.0)).xyz;
  bool facesLight = dot(mat3(modelMatrix) * faceNormal, travelInWorld) < 0.0;
  // The inset sinks the start under the lit faces, which would otherwise fight their own volume for depth.
  world += travelInWorld * (facesLight ? inset : extent);
  gl_Position = clipFromView * viewFromWorld * vec4(world, 1.0);
}
