precision highp float;

// The outline of a surface: its back faces, moved outwards in clip space by the width of the line (inverted hull). The
// width in pixels is the same at any distance, for perspective and orthographic cameras.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform float inkPixels;
uniform float inkSwell;
uniform vec4 lightInView;
uniform bool isRaised;

in vec3 position;
in vec3 hullNormal;
// Index of the surface, number of its group, and row of the transform.
in vec3 surfaceGroupRow;

flat out float group;

#include ../lib/pixel.glsl
#include ../lib/ink.glsl
#include ../lib/light.glsl
#include ../lib/transforms.glsl

// Distance by which the raised hull is nearer, so that its line does not sink into the ground: line widths, and the
// limit in metres, so that a line that is wide in the world does not cover protruding parts of its own surface.
const vec2 HULL_RAISED = vec2(6.0, 0.05);

// Clip z of a vertex moved towards the camera by a distance in view units, without moving it on the screen.
float raisedClipZ(float viewZ, float clipW, float nearer) {
  float clipZ = clipFromView[2][2] * (viewZ + nearer) + clipFromView[3][2];
  return clipZ / (clipFromView[2][3] * (viewZ + nearer) + clipFromView[3][3]) * clipW;
}

void main() {
  mat4 transform = worldFromModel(int(surfaceGroupRow.z));
  group = surfaceGroupRow.y;
  mat4 viewFromModel = viewFromWorld * transform;
  vec4 inView = viewFromModel * vec4(position, 1.0);
  vec4 clip = clipFromView * inView;
  vec2 outward = vec2(clipFromView[0][0], clipFromView[1][1]) * (mat3(viewFromModel) * hullNormal).xy * viewport;
  float length2 = dot(outward, outward);
  outward *= length2 > 1e-12 ? inversesqrt(length2) : 0.0;
  float pixels = inkPixels * swelling(outward, towardsLightFrom(lightInView, inView.xyz), inkSwell);
  clip.xy += outward * pixels * 2.0 / viewport * clip.w;
  float widthInView = max(pixels, inkPixels) * viewUnitsPerPixel(clipFromView, viewport, inView.z);
  clip.z = raisedClipZ(inView.z, clip.w, isRaised ? min(HULL_RAISED.x * widthInView, HULL_RAISED.y) : 0.0);
  gl_Position = clip;
}
