precision highp float;

// Writes the depth where the view ray through this pixel enters (front face) or leaves (back face) the volume.
// Counted by depth pass: entries in front of the receiver minus exits in front of it = volumes that hold the receiver.
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform vec2 viewportOrigin;
uniform float near;

flat in vec3 start;
flat in vec3 axis;
flat in float extent;
flat in float radius;
flat in float growth;

#include ../lib/depth.glsl
#include ../lib/cone.glsl

void main() {
  vec2 ndc = (gl_FragCoord.xy - viewportOrigin) / viewport * 2.0 - 1.0;
  vec2 scale = vec2(clipFromView[0][0], clipFromView[1][1]);
  bool perspective = clipFromView[2][3] != 0.0;
  // Both rays have unit length along -z, so that the ray parameter is the view depth.
  vec3 origin = perspective ? vec3(0.0) : vec3((ndc - clipFromView[3].xy) / scale, 0.0);
  vec3 ray = perspective ? vec3((ndc + clipFromView[2].xy) / scale, -1.0) : vec3(0.0, 0.0, -1.0);
  vec2 inside = rayInCone(origin, ray, start, axis, extent, radius, growth);
  if (inside.x >= inside.y || inside.y <= near) discard;
  float depth = gl_FrontFacing ? max(inside.x, near) : inside.y;
  gl_FragDepth = clamp(windowDepth(clipFromView, -depth), 0.0, 1.0);
}
