precision highp float;

// A sharp edge of a surface, or a seam of two surfaces, as a ribbon of constant width in pixels. An edge with a face
// that looks away belongs to the silhouette, which the hull draws, and is skipped. The normals of a seam are zero.
// Edges are in model space; the ribbon is widened in clip space. Four vertices make a ribbon: instances of one quad would
// be a draw call each on some GPUs.
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform float near;
uniform float inkPixels;

// Four texels for each edge: start and index of the surface, end, normals of both faces.
uniform highp sampler2D edges;

#include ../lib/pixel.glsl
#include ../lib/transforms.glsl

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

vec4 texelOf(int edge, int texel) {
  int perRow = textureSize(edges, 0).x / 4;
  return texelFetch(edges, ivec2(4 * (edge % perRow) + texel, edge / perRow), 0);
}

void main() {
  int edge = gl_VertexID / 4;
  // x: 0 at the start, 1 at the end; y: -1 and 1 on the two sides.
  int number = gl_VertexID % 4;
  vec2 corner = vec2(number == 1 || number == 2, number < 2 ? -1.0 : 1.0);
  vec4 startAndSurface = texelOf(edge, 0);
  vec3 oneNormal = texelOf(edge, 2).xyz;
  vec3 otherNormal = texelOf(edge, 3).xyz;
  // An invisible surface has a transform of zeros, and all its edges are at the camera, before the near plane.
  mat4 viewFromModel = viewFromWorld * worldFromModel(int(startAndSurface.w));
  vec3 from = (viewFromModel * vec4(startAndSurface.xyz, 1.0)).xyz;
  vec3 to = (viewFromModel * vec4(texelOf(edge, 1).xyz, 1.0)).xyz;
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
