precision highp float;
precision highp int;
precision highp sampler2DArray;

// Shades a billboard puff and writes its depth (McGuire and Fein 2006, section 4.1). The depth layer raises each
// fragment from the centre plane. The ring around the silhouette is ink and is deeper, so the depth test alone decides
// which lines are visible. Normals and light are in view space. Outputs the display-encoded lit colour (alpha 0: no
// mask yet) and the unlit colour (with the alpha of the page).
uniform sampler2DArray normalDepth;
uniform sampler2DArray colorCoverage;
uniform sampler2D ramps;
uniform float pad;
uniform float distanceRange;
uniform mat4 clipFromView;
uniform float near;
uniform vec2 viewport;
uniform vec3 inkColor;
uniform float inkPixels;
uniform float inkSwell;
uniform float innerTaper;
uniform float boil;
uniform vec3 gradientFactor;
uniform vec3 rimColor;
uniform float rim;

in vec2 puffPoint;
in float gradientPosition;
flat in int variation;
flat in vec2 rollRotation;
flat in float inkReach;
flat in float phase;
flat in float centreZ;
flat in float radius;
flat in float ringDrop;
flat in float rampIndex;
flat in vec3 towardsLight;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;
#ifdef SHADING
layout(location = 2) out vec4 shading;
#endif
#ifdef PLACES
layout(location = 3) out vec4 surfacePlace;
vec4 packPlace(vec3 place);
#endif

#include ../lib/depth.glsl
#include ../lib/srgb.glsl
#include ../lib/shade.glsl
#include ../lib/shading.glsl
#include ../lib/pixel.glsl
#include ../lib/gradient.glsl
#include ../lib/ink.glsl
#include ../lib/contact.glsl
#include clipping.glsl

// Bodies avoid both ends of the depth range: a volume that contains the camera is clamped to exactly 0 and must be
// nearer.
const float DEPTH_MARGIN = 4e-7;

// Rotates from texture space to view space.
vec2 rotated(vec2 vector) {
  return vec2(rollRotation.x * vector.x - rollRotation.y * vector.y, rollRotation.x * vector.y + rollRotation.y * vector.x);
}

void main() {
  vec3 layerPoint = vec3(0.5 + 0.5 * puffPoint / pad, float(variation));
  vec4 shape = texture(normalDepth, layerPoint);
  vec4 paint = texture(colorCoverage, layerPoint);
  float distanceOutside = (paint.a - 0.5) * distanceRange;
  vec2 outward = rotated(puffPoint) / max(length(puffPoint), 1e-6);
  float reach = inkReach * exp2(-inkSwell) * swelling(outward, towardsLight, inkSwell);
  reach *= boiling(outward, phase, boil);
  if (distanceOutside > reach) discard;
  bool isRing = distanceOutside > 0.0;
  float pixel = viewUnitsPerPixel(clipFromView, viewport, centreZ);
  float linePixels = reach * radius / pixel;

  vec3 normal = shape.rgb * 2.0 - 1.0;
  normal.xy = rotated(normal.xy);
  normal = normalize(normal);
  float viewZ = min(centreZ + (shape.a - 0.5) * 2.0 * pad * radius, -near);
  vec2 here = surfaceHere(clipFromView);
  bool isInk = isRing || isSeam(clipFromView, here.y, viewZ, normal, pixel, linePixels);
  float fullLine = inkPixels * exp2(inkSwell);
#ifdef LOOKS
  fullLine *= inkWeightOf(rampIndex);
#endif
  float ink = isInk ? inkShare(linePixels, fullLine, radius / pixel) : 0.0;
#ifdef PLACES
  surfacePlace = packPlace(vec3(rotated(puffPoint), (viewZ - centreZ) / radius));
#endif
  float position = gradientAt(gradientPosition, viewZ);
  Lighting light = lightingOf(normal, towardsLight, rim);
  float material = rampIndex;
#ifdef FALLOFF
  float strengthCode = takeStrength(material);
#endif
#ifdef LOOKS
  material = withoutLook(material);
#endif
#ifdef SHADING
  shading = packShading(Shading(light.facing, material, light.isFilled, light.isRim, ink > 0.0, radius));
  unlit.rgb = paint.rgb;
#ifdef ADDITIONAL_LIGHTS
  vec3 shown = vec3(viewPointOf(gl_FragCoord.xy, clipFromView, viewport, viewZ), viewZ);
  lit.rgb = vec3(packPosition(position, lightsOn(normal, shown, SMOKE_BORDER)), ink);
#else
  lit.rgb = vec3(packPosition(position), ink);
#endif
#else
  vec3 gradient = paint.rgb * mix(gradientFactor, vec3(1.0), position);
  Shades shades = shade(light, ramps, material, gradient, rimColor);
  unlit.rgb = mix(shades.unlit, inkColor, ink);
  lit.rgb = mix(shades.lit, inkColor, ink);
#endif
  unlit.a = 1.0;
#if defined(SHADING) && defined(FALLOFF)
  unlit.a = strengthCode;
#endif
  lit.a = ink < 1.0 ? 0.0 : 1.0;

  float outside = distanceOutside * radius;
  float depth = windowDepth(clipFromView, viewZ);
  if (isRing) depth = ringDepth(clipFromView, here, viewZ, viewZ - ringDrop * sinking(outside / pixel, linePixels, innerTaper), outside, -outward * (outside / pixel + 0.5));
  gl_FragDepth = clamp(depth, DEPTH_MARGIN, 1.0 - DEPTH_MARGIN);
#ifdef CLIPPED
  // With a surface, its line is cut off, which is deeper.
  if (isCutOff(clipFromView, viewport, depth) || isCutOff(clipFromView, viewport, windowDepth(clipFromView, viewZ))) discard;
#endif
}
