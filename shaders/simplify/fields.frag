precision highp float;
precision highp int;

// Prepares the light of a picture for smoothing.
uniform sampler2D unlit;
uniform highp sampler2D depth;
uniform mat4 clipFromView;
// Least depth between two puffs that separates them, in radii.
uniform float innerLine;
// Whether bands of colour are separate. Interpolated bands are not.
uniform bool isBanded;

// See packField.glsl.
out vec4 field;

#include ../lib/depth.glsl
#include field.glsl
#include packField.glsl

// Least gap in depth, in radii. Smaller gaps have ink, or belong to one shape.
const float MIN_GAP = 1.0;
// Difference of display-encoded colours of the same surface.
const float SAME_COLOR = 0.02;

struct Texel {
  Shading shading;
  float viewZ;
  vec4 unlit;
  vec4 lit;
};

Texel texelAt(ivec2 at) {
  vec4 light = texelFetch(lit, at, 0);
  float z = viewZOf(clipFromView, texelFetch(depth, at, 0).r);
  return Texel(unpackShading(texelFetch(shading, at, 0)), z, texelFetch(unlit, at, 0), light);
}

bool isLinked(Texel a, Texel b) {
  if (a.shading.isInk || b.shading.isInk || (a.shading.radius > 0.0) != (b.shading.radius > 0.0)) return false;
  if (a.shading.radius == 0.0) {
    vec3 gap = max(abs(a.unlit.rgb - b.unlit.rgb), abs(a.lit.rgb - b.lit.rgb));
    return max(max(gap.r, gap.g), gap.b) < SAME_COLOR && a.unlit.a == b.unlit.a;
  }
  if (isBanded && a.shading.material != b.shading.material) return false;
  float gap = max(innerLine, MIN_GAP) * max(a.shading.radius, b.shading.radius);
  return abs(a.viewZ - b.viewZ) < gap;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(lit, 0) - 1;
  Texel here = texelAt(at);
  bool right = at.x < last.x && isLinked(here, texelAt(at + ivec2(1, 0)));
  bool above = at.y < last.y && isLinked(here, texelAt(at + ivec2(0, 1)));
  int links = (right ? LINKED_RIGHT : 0) + (above ? LINKED_ABOVE : 0);
#ifdef ADDITIONAL_LIGHTS
  int lights = here.shading.radius > 0.0 ? unpackLights(here.lit.rg) : 0;
  field = packField(PackedField(fieldOf(here.shading, here.lit.a), links, lights));
#else
  field = packField(PackedField(fieldOf(here.shading, here.lit.a), links));
#endif
}
