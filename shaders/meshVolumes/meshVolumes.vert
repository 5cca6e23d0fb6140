precision highp float;

// The shadow volume of a closed mesh. Each face has its own vertices. Faces that look away from the light are moved
// along it, and the quads between neighbouring faces open into the sides. Positions and normals are in model space,
// extrusion is in world space.
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

// Margin of the box, metres: the distance out of a box can be larger between two vertices than at both. Triangles are
// small enough for this margin.
const float MARGIN = 0.1;

// Rays of a lamp diverge by the length of an edge per distance from the lamp. Limit of that growth.
const float WIDEST = 0.5;

float extentOf(vec3 world, vec3 travel) {
  float growth = lightInWorld.w * min(WIDEST, longestEdge / max(length(world - lightInWorld.xyz), 1e-6));
  return exitFromBox(world, travel, receiversMin, receiversMax, MARGIN, growth);
}

void main() {
  vec3 world = (modelMatrix * vec4(position, 1.0)).xyz;
  vec3 travel = -towardsLightFrom(lightInWorld, world);
  bool facesLight = dot(mat3(modelMatrix) * faceNormal, travel) < 0.0;
  // The inset starts the volume below the lit faces, which otherwise z-fight with it.
  world += travel * (facesLight ? inset : max(extentOf(world, travel), inset));
  gl_Position = clipFromView * viewFromWorld * vec4(world, 1.0);
}
