precision highp float;
precision highp int;

// The opacity of the strokes of an arc, which taper to both ends, where no smoke is before its lobe.
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform float inkSwell;
uniform float boil;
// See strokeRanges.frag.
uniform highp usampler2D strokes;

in vec3 besideAndZ;
flat in int arc;
flat in vec4 frame;
flat in vec4 line;
flat in vec4 bulgeAndSqueeze;

out vec4 coverage;

#include ../lib/depth.glsl
#include smokeDepth.glsl
#include ../lib/ink.glsl
#include ../lib/pixel.glsl
#include ../bodies/clipping.glsl
#ifdef DEFORMED
#include ../lib/stretch.glsl
#endif
#include tile.glsl

// Height of smoke before the lobe, in its radii, that hides a stroke.
const float COVER = 0.04;
// Share of a place in the length of a stroke, or -1 outside, and the opacity of the stroke.
vec2 shareAt(float along, int number) {
  vec3 stroke = vec3(texelFetch(strokes, texelOf(arc, number), 0).rgb) / 65535.0;
  vec2 ends = 2.0 * stroke.xy - 1.0;
  bool isInside = along >= ends.x && along <= ends.y && ends.x < ends.y;
  return vec2(isInside ? (along - ends.x) / (ends.y - ends.x) : -1.0, stroke.z);
}

void main() {
  vec2 beside = besideAndZ.xy;
  float along = atan(dot(beside, vec2(-frame.y, frame.x)), dot(beside, frame.xy)) / frame.z;
  if (abs(along) > 1.0) discard;
  float place = 0.5 * (along + 1.0) * float(LAST);
  int number = min(int(place), LAST - 1);
  vec2 found = shareAt(along, number);
  if (found.x < 0.0) found = shareAt(along, number + 1);
  if (found.x < 0.0) discard;

  float reach = length(beside);
  vec2 normal = beside / reach;
  float distance = (reach - 1.0) * frame.w;
#ifdef DEFORMED
  Projection projection = Projection(bulgeAndSqueeze.yz, bulgeAndSqueeze.w, 1.0, vec2(0.0));
  vec2 gradient = scaled(projection, normal, projection.factor);
  distance /= length(gradient);
  normal = normalize(gradient);
#endif
  float width = line.x * swelling(normal, vec3(line.zw, 0.0), inkSwell) * boiling(normal, line.y, boil);
  // A weak stroke is thin, not pale.
  width *= 4.0 * found.x * (1.0 - found.x) * found.y * (1.5 - 0.5 * found.y);
  // The part of the pixel that the stroke covers. The edge filter would break up lines of about a pixel.
  float covered = min(distance + 0.5, 0.5 * width) - max(distance - 0.5, -0.5 * width);
  if (covered <= 0.0) discard;

  float z = smokeZ(clipFromView, gl_FragCoord.xy);
  float top = besideAndZ.z + bulgeAndSqueeze.x * (sqrt(max(0.0, 1.0 - reach * reach)) + COVER);
  if (z < NO_SMOKE || z > top) discard;
  if (isCutOff(clipFromView, viewport, windowDepth(clipFromView, besideAndZ.z))) discard;
  coverage = vec4(min(1.0, covered));
}
