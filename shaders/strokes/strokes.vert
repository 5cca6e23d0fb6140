precision highp float;
precision highp int;

// A stroke: a strip along an arc of the outline of a lobe, where the lobe stands before other smoke. The arc has a sample at
// each pair of vertices. A stroke covers a row of samples that stand before other smoke, and tapers to both ends.
uniform float inkPixels;
uniform float inkSwell;
uniform float boil;
uniform int drawing;
// How well the lobe stands before other smoke at each sample, 0..1: see standing.vert.
uniform sampler2D standings;

// Point from the centre of the lobe, in its radii.
out vec2 beside;
// View z of the outline, and height of the lobe before it in view units.
out float outlineZ;
flat out float bulge;
out float opacity;

#include ../lib/rows.glsl
#include ../lib/pixel.glsl
#include ../lib/light.glsl
#include ../lib/ink.glsl
#include ../lib/attributes.glsl
#include ../lib/orientation.glsl
#include arc.glsl

// Reach of the average about the middle of a stroke, at least in CSS pixels and as a share of its arc, and the averages at
// which a stroke begins and is complete. A row of samples of length l gives 1 - (1 - l / (2 reach))^2, so that a stroke has
// at least 12 CSS pixels, and is no straight dash.
const float REACH = 40.0;
const float REACH_OF_ARC = 0.35;
const vec2 AVERAGES = vec2(0.34, 0.85);
// Width of a stroke that begins or ends, as a share. It fades below.
const float THINNEST = 0.5;

int stroke;

// The standing about a sample. The average closes narrow gaps, such as where a line of smoke behind meets the outline.
float standing(int number) {
  const int TAPS = 1;
  float sum = 0.0;
  for (int i = -TAPS; i <= TAPS; i++) {
    float weight = float(TAPS + 1 - abs(i));
    sum += weight * texelFetch(standings, texelOf(stroke, clamp(number + i, 0, LAST)), 0).r;
  }
  return sum / float((TAPS + 1) * (TAPS + 1));
}

// The average standing about a place on the arc. The arc is as long as 2 in `along`.
float averageStanding(float along) {
  float reach = 2.0 * max(REACH / arcLength, REACH_OF_ARC);
  float sum = 0.0;
  for (int i = 0; i <= LAST; i++) {
    float weight = max(0.0, 1.0 - abs(alongOf(i) - along) / reach);
    sum += weight * texelFetch(standings, texelOf(stroke, i), 0).r;
  }
  return sum * 2.0 / (float(LAST) * reach);
}

void main() {
  stroke = gl_VertexID / rowVertices;
  int number = (gl_VertexID % rowVertices) / 2;
  float side = float(gl_VertexID % 2) * 2.0 - 1.0;
  gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  opacity = 0.0;
  if (!isCandidate(stroke)) return;
  fetchRow(stroke);
  opacity = findArc();
  if (opacity <= 0.0) return;
  bulge = height;

  float here = standing(number);
  float along = alongOf(number);
  float from = along;
  float to = along;
  if (here >= 0.5) {
    for (int way = -1; way <= 1; way += 2) {
      float last = here;
      float end = along;
      for (int i = number + way; i >= 0 && i <= LAST; i += way) {
        float next = standing(i);
        end += (alongOf(i) - end) * (next < 0.5 ? (last - 0.5) / (last - next) : 1.0);
        last = next;
        if (next < 0.5) break;
      }
      if (way < 0) from = end;
      else to = end;
    }
  } else {
    // Beside a stroke, this vertex is its end.
    float before = number > 0 ? standing(number - 1) : 0.0;
    float after = number < LAST ? standing(number + 1) : 0.0;
    float spacing = 2.0 / float(LAST);
    if (before >= 0.5) along -= spacing * (0.5 - here) / (before - here);
    else if (after >= 0.5) along += spacing * (0.5 - here) / (after - here);
  }
  float share = to > from ? (along - from) / (to - from) : 0.0;
  // Not a smoothstep, which is steeper.
  opacity *= clamp((averageStanding(0.5 * (from + to)) - AVERAGES.x) / (AVERAGES.y - AVERAGES.x), 0.0, 1.0);

  vec2 normal = viewNormal(outwardAt(along));
  float width = lineWidth(inkPixels * exp2(inkSwell), radius / pixel) * exp2(-inkSwell);
  width *= swelling(normal, towardsLightFrom(lightInView, centre), inkSwell);
  width *= boiling(normal, boilPhase(seedOf(attributes), drawing), boil);
  width *= 4.0 * share * (1.0 - share) * mix(THINNEST, 1.0, opacity);
  // A strip thinner than a pixel would break up into dots.
  opacity *= min(1.0, width);
  vec2 place = placeAt(along) + normal * (side * 0.5 * max(1.0, width) * pixel);
  gl_Position = clipAt(place);
  gl_Position.z = 0.0;
  beside = (unviewPoint(place / radius) - lobe.xy) / lobe.w;
  outlineZ = outlineZAt(along);
}
