precision highp float;

// A sharp edge of a surface, or a seam of two surfaces, as a ribbon of constant width in pixels. An edge with a face
// that looks away belongs to the silhouette, which the hull draws, and is skipped. The normals of a seam are zero.
// Inputs are in model space; the ribbon is widened in clip space.
uniform mat4 modelMatrix;
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform float near;
uniform float inkPixels;

// x: 0 at the start, 1 at the end; y: -1 and 1 on the two sides.
in vec2 corner;
in vec3 start;
in vec3 end;
in vec3 oneNormal;
in vec3 otherNormal;

#include ../lib/pixel.glsl

// Distance of a ribbon in front of its surface: line widths, and the upper limit in metres. A seam is in a hollow and
// needs a larger distance.
const vec2 CREASE_RAISED = vec2(0.75, 0.03);
const vec2 SEAM_RAISED = vec2(3.0, 0.05);

bool looksAway(mat3 rotation, vec3 normal, vec3 towardsEye) {
  return dot(rotation * normal, towardsEye) < 0.0;
}

// Pixels of the target, relative to its centre.
vec2 onScreen(vec3 place) {
  vec4 clip = clipFromView * vec4(place, 1.0);
  return 0.5 * viewport * clip.xy / clip.w;
}

// Clips the edge at the near plane.
vec3 clipped(vec3 place, vec3 other) {
  float depth = -place.z;
  return depth >= near ? place : mix(place, other, clamp((near - depth) / (-other.z - depth), 0.0, 1.0));
}

void main() {
  mat4 viewFromModel = viewFromWorld * modelMatrix;
  vec3 from = (viewFromModel * vec4(start, 1.0)).xyz;
  vec3 to = (viewFromModel * vec4(end, 1.0)).xyz;
  mat3 rotation = mat3(viewFromModel);
  vec3 towardsEye = clipFromView[2][3] != 0.0 ? -from : vec3(0.0, 0.0, 1.0);
  bool isHidden = max(-from.z, -to.z) < near;
  if (isHidden || looksAway(rotation, oneNormal, towardsEye) || looksAway(rotation, otherNormal, towardsEye)) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec3 place = corner.x < 0.5 ? clipped(from, to) : clipped(to, from);
  vec2 along = onScreen(clipped(to, from)) - onScreen(clipped(from, to));
  along = length(along) > 1e-4 ? normalize(along) : vec2(1.0, 0.0);
  // Half a width beyond each end closes the gaps between edges that meet at an angle.
  vec2 beside = 0.5 * inkPixels * (corner.y * vec2(-along.y, along.x) + (2.0 * corner.x - 1.0) * along);
  vec4 clip = clipFromView * vec4(place, 1.0);
  clip.xy += beside * 2.0 / viewport * clip.w;
  vec2 limit = oneNormal == vec3(0.0) ? SEAM_RAISED : CREASE_RAISED;
  float raised = min(limit.x * inkPixels * viewUnitsPerPixel(clipFromView, viewport, place.z), limit.y);
  vec4 raisedClip = clipFromView * vec4(0.0, 0.0, min(place.z + raised, -near), 1.0);
  clip.z = raisedClip.z / raisedClip.w * clip.w;
  gl_Position = clip;
}
