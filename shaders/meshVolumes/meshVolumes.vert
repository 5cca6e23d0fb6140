precision highp float;

// The shadow volumes of closed meshes. Each vertex exists twice: at the start of its volume, and moved along the light
// to the end. src/renderer/passes/meshVolumes.ts chooses the triangles. Positions are in model space, extrusion is in world space.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec4 lightInWorld;
uniform vec3 receiversMin;
uniform vec3 receiversMax;
uniform float inset;
// Number of the first vertex at the end of a volume.
uniform int firstFar;

in vec3 position;
// Index of the surface, and the length of its longest edge.
in vec2 surfaceAndEdge;

#include ../lib/box.glsl
#include ../lib/light.glsl
#include ../lib/transforms.glsl

// Margin of the box, metres: the distance out of a box can be larger between two vertices than at both. Triangles are
// small enough for this margin.
const float MARGIN = 0.1;

// Rays of a lamp diverge by the length of an edge per distance from the lamp. Limit of that growth.
const float WIDEST = 0.5;

float extentOf(vec3 world, vec3 travel) {
  float growth = lightInWorld.w * min(WIDEST, surfaceAndEdge.y / max(length(world - lightInWorld.xyz), 1e-6));
  return exitFromBox(world, travel, receiversMin, receiversMax, MARGIN, growth);
}

void main() {
  vec3 world = (worldFromModel(int(surfaceAndEdge.x)) * vec4(position, 1.0)).xyz;
  vec3 travel = -towardsLightFrom(lightInWorld, world);
  // The inset starts the volume below the lit faces, which otherwise z-fight with it.
  world += travel * (gl_VertexID < firstFar ? inset : max(extentOf(world, travel), inset));
  gl_Position = clipFromView * viewFromWorld * vec4(world, 1.0);
}
