precision highp float;
precision highp int;

// Intersects the lobes of a puff along the view axis, shades the nearest point and writes its depth. The ring around
// the silhouette is ink and is deeper (McGuire and Fein 2006, section 4.1), so the depth test alone decides which lines
// are visible. three.js unrolls the marked loops, because dynamic indexing would be much slower. Lobes and normals are
// in view space. Outputs the display-encoded unlit and lit colour.
// DEFORMED: points, heights and lobes are those of stretch.glsl, except in names with `view`.
// CUT: puffs with bites; src/renderer/bites.ts adds bites/lobesFragment.glsl.
// FLAT: see lobes.vert; the quad that faces away draws the ink.
uniform sampler2D ramps;
uniform float fillet;
uniform float blend;
uniform mat4 clipFromView;
uniform float near;
uniform vec2 viewport;
uniform vec4 lightInView;
uniform vec3 inkColor;
uniform float inkPixels;
uniform float inkSwell;
uniform float innerTaper;
uniform float boil;
uniform vec3 gradientFactor;
uniform vec3 rimColor;
uniform float rim;

// w: phase of the boil of this puff's line.
in vec4 pointAndGradient;
flat in vec4 middleAndInkReach;
flat in vec4 depthsAndRamp;
flat in vec4 lobes[LOBES];

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
#include ../lib/light.glsl
#include ../lib/srgb.glsl
#include ../lib/shade.glsl
#include ../lib/shading.glsl
#include ../lib/pixel.glsl
#include ../lib/gradient.glsl
#include ../lib/ink.glsl
#include ../lib/contact.glsl
#include clipping.glsl
#ifdef DEFORMED
uniform float innerLine;
#include ../lib/attributes.glsl
#include ../lib/stretch.glsl
Projection projection;
#endif

// Bodies avoid both ends of the depth range: a volume that contains the camera is clamped to exactly 0 and must be
// nearer.
const float DEPTH_MARGIN = 4e-7;
const float NOWHERE = -1e8;

#ifdef CUT
void meetBites(vec2 point);
float frontOfRest(vec4 lobe, float squared);
bool hasBiteLine(vec3 place, bool isRing, vec4 line, float reach, inout vec3 normal, inout vec3 viewNormal);
// Least distance from the surfaces of lobes, less than 0 within.
float deepest = 0.0;
#endif

// Height of a lobe's front surface at a point of the image plane.
float frontOf(vec4 lobe, vec2 point) {
  vec2 beside = point - lobe.xy;
  float squared = lobe.w * lobe.w - dot(beside, beside);
#ifdef CUT
  return frontOfRest(lobe, squared);
#else
  return squared > 0.0 ? lobe.z + sqrt(squared) : NOWHERE;
#endif
}

// The nearer of two silhouettes that the point is outside of. xy: centre of its lobe, z: its height, w: distance to it.
// Lobes that are hidden by a surface of height `surface` have no line.
vec4 nearerRim(vec4 nearest, vec4 lobe, vec2 point, float surface) {
  float outside = length(point - lobe.xy) - lobe.w;
  bool isHidden = lobe.z + STEEPEST * outside < surface;
  return outside > 0.0 && outside < nearest.w && !isHidden ? vec4(lobe.xyz, outside) : nearest;
}

// The outward direction of a lobe at a point, weighted by the fillet that blends normals along creases.
vec3 shareOf(vec4 lobe, vec3 place, float perFillet) {
  vec3 outward = place - lobe.xyz;
  float squared = max(dot(outward, outward), 1e-12);
  float inverse = inversesqrt(squared);
  float away = squared * inverse - lobe.w;
#ifdef CUT
  deepest = min(deepest, away);
#endif
  float nearness = max(0.0, 1.0 - abs(away) * perFillet);
  return outward * (nearness * nearness * inverse);
}

// A point of the image plane in view space, in radii about the centre.
vec2 viewPoint(vec2 point) {
#ifdef DEFORMED
  return scaled(projection, point, 1.0 / projection.factor);
#else
  return point;
#endif
}

// The height of a point in view space, and back.
float viewHeight(float height, vec2 point) {
#ifdef DEFORMED
  return height / projection.depth - dot(projection.shear, viewPoint(point));
#else
  return height;
#endif
}

float heightOf(float viewHeight, vec2 point) {
#ifdef DEFORMED
  return projection.depth * (viewHeight + dot(projection.shear, viewPoint(point)));
#else
  return viewHeight;
#endif
}

// The direction in view space in which the distance from a lobe grows by `outward`, and how fast it does.
vec2 viewGradient(vec2 outward) {
#ifdef DEFORMED
  return scaled(projection, outward, projection.factor);
#else
  return outward;
#endif
}

// The centre in view space. The whole puff is lit as at its centre, because the start cap of its shadow volume depends
// on one direction.
vec3 centreOf(vec2 point) {
  vec2 beside = viewPointOf(gl_FragCoord.xy, clipFromView, viewport, depthsAndRamp.x);
  return vec3(beside - depthsAndRamp.y * viewPoint(point), depthsAndRamp.x);
}

void main() {
  vec2 point = pointAndGradient.xy;
#ifdef DEFORMED
  vec4 stretch = stretchOf(uint(depthsAndRamp.z));
  projection = projectionOf(vec4(mat3(viewFromWorld) * stretch.xyz, stretch.w));
  float lineDrop = innerLine * depthsAndRamp.y;
#else
  float lineDrop = depthsAndRamp.z;
#endif
  vec3 towardsLight = towardsLightFrom(lightInView, centreOf(point));
#ifdef CUT
  meetBites(point);
#endif
  float height = NOWHERE;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    height = max(height, frontOf(lobes[ i ], point));
  }
  #pragma unroll_loop_end

  float radius = depthsAndRamp.y;
  float pixel = viewUnitsPerPixel(clipFromView, viewport, depthsAndRamp.x);
  vec2 outward = normalize(viewPoint(point - middleAndInkReach.xy));
  float reach = middleAndInkReach.w * swelling(outward, towardsLight, inkSwell);
  reach *= boiling(outward, pointAndGradient.w, boil);
  float pixels = radius / pixel;
  float linePixels = reach * pixels;
  // Where a surface hides the nearest lobe, the line of a neighbouring lobe may still be in front of that surface.
#ifdef FLAT
  float surface = NOWHERE;
#else
  vec2 here = surfaceHere(clipFromView);
  float surface = heightOf((here.y - depthsAndRamp.x) / radius, point);
#endif
  bool isRing = height <= max(NOWHERE, surface);
#ifdef FLAT
  if (isRing == gl_FrontFacing) discard;
#endif
  vec4 line = vec4(0.0, 0.0, 0.0, 1e9);
  if (isRing) {
    #pragma unroll_loop_start
    for (int i = 0; i < LOBES; i++) {
      line = nearerRim(line, lobes[ i ], point, surface - 2.0 * reach);
    }
    #pragma unroll_loop_end
#ifdef DEFORMED
    line.w /= length(viewGradient(normalize(point - line.xy)));
#endif
    if (line.w > reach) discard;
    height = line.z;
  }

  vec3 place = vec3(point, height);
  vec3 normal = vec3(0.0);
  float perFillet = 1.0 / fillet;
  #pragma unroll_loop_start
  for (int i = 0; i < LOBES; i++) {
    normal += shareOf(lobes[ i ], place, perFillet);
  }
  #pragma unroll_loop_end
  normal = normalize(normal);
  vec3 viewNormal = normal;
  normal = mix(normal, normalize(place - middleAndInkReach.xyz), blend);
  float viewZ = min(depthsAndRamp.x + viewHeight(height, point) * radius, -near);
  bool isInk = isRing;
#ifdef CUT
  if (hasBiteLine(place, isRing, line, reach, normal, viewNormal)) {
    isInk = true;
    viewZ -= lineDrop;
  }
#endif
#ifdef DEFORMED
  viewNormal = normalize(stretchedNormal(projection, viewNormal));
#endif
#ifndef FLAT
  isInk = isInk || isSeam(clipFromView, here.y, viewZ, viewNormal, pixel, linePixels);
#endif
  float fullLine = inkPixels * exp2(inkSwell);
#ifdef LOOKS
  fullLine *= inkWeightOf(depthsAndRamp.w);
#endif
  float ink = isInk ? inkShare(linePixels, fullLine, pixels) : 0.0;
#ifdef DEFORMED
  normal = stretchedNormal(projection, normal);
#endif

#ifdef PLACES
  surfacePlace = packPlace(vec3(viewPoint(point), viewHeight(height, point)));
#endif
  float position = gradientAt(pointAndGradient.z, viewZ);
  Lighting light = lightingOf(normalize(normal), towardsLight, rim);
  float material = depthsAndRamp.w;
#ifdef FALLOFF
  float strengthCode = takeStrength(material);
#endif
#ifdef LOOKS
  material = withoutLook(material);
#endif
#ifdef SHADING
  shading = packShading(Shading(light.facing, material, light.isFilled, light.isRim, ink > 0.0, radius));
  unlit.rgb = vec3(1.0);
#ifdef ADDITIONAL_LIGHTS
  vec3 shown = vec3(viewPointOf(gl_FragCoord.xy, clipFromView, viewport, viewZ), viewZ);
  lit.rgb = vec3(packPosition(position, lightsOn(normalize(normal), shown, SMOKE_BORDER)), ink);
#else
  lit.rgb = vec3(packPosition(position), ink);
#endif
#else
  vec3 gradient = mix(gradientFactor, vec3(1.0), position);
  Shades shades = shade(light, ramps, material, gradient, rimColor);
  unlit.rgb = mix(shades.unlit, inkColor, ink);
  lit.rgb = mix(shades.lit, inkColor, ink);
#endif
  unlit.a = 1.0;
#if defined(SHADING) && defined(FALLOFF)
  unlit.a = strengthCode;
#endif
  lit.a = ink < 1.0 ? 0.0 : 1.0;

#ifdef FLAT
  float depth = gl_FragCoord.z;
#else
  float outside = line.w * pixels;
  vec2 inward = normalize(viewGradient(line.xy - point)) * (outside + 0.5);
  float depth = windowDepth(clipFromView, viewZ);
  if (isRing) depth = ringDepth(clipFromView, here, viewZ, viewZ - lineDrop * sinking(outside, linePixels, innerTaper), line.w * radius, inward);
  gl_FragDepth = clamp(depth, DEPTH_MARGIN, 1.0 - DEPTH_MARGIN);
#endif
#ifdef CLIPPED
  // With a surface, its line is cut off, which is deeper.
  if (isCutOff(clipFromView, viewport, depth) || isCutOff(clipFromView, viewport, windowDepth(clipFromView, viewZ))) discard;
#endif
}
