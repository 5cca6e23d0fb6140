precision highp float;
precision highp int;

// A triangle around each arc that has samples. Its sides touch the circle of the arc and the line between its ends.
uniform float inkPixels;
uniform float inkSwell;
uniform int drawing;
uniform sampler2D separations;

// Point from the centre of the lobe, in its radii, and view z of the plane of the outline there.
out vec3 besideAndZ;
flat out int arc;
// Unit vector to the middle of the arc; half angle; radius of the lobe, pixels.
flat out vec4 frame;
// Width of the line without swell, pixels; phase of the boil; direction to the light.
flat out vec4 line;
// Height of the lobe before its outline, view units. DEFORMED: direction and factor of the projection.
flat out vec4 bulgeAndSqueeze;

#include arc.glsl
#include ../lib/ink.glsl
#ifdef LOOKS
float withLook(float material, uvec4 attributes);
#endif

// Tangent of half the angle between the sides that touch the circle.
const float SLOPE = 0.57735;

void main() {
  gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  arc = gl_VertexID / 3;
  if (texelFetch(separations, texelOf(arc, LAST_TEXEL), 0).r == 0.0) return;
  fetchArc(arc);
  findArc();
  float size = lobe.w * radius / pixel;
  float fullLine = inkPixels * exp2(inkSwell);
#ifdef LOOKS
  fullLine *= inkWeightOf(withLook(0.0, attributes));
#endif
  float greatest = lineWidth(fullLine, radius / pixel);
  frame = vec4(cos(middle), sin(middle), halfAngle, size);
  vec3 light = towardsLightFrom(lightInView, centre);
  line = vec4(greatest * exp2(-inkSwell), boilPhase(seedOf(attributes), drawing), light.xy);
  bulgeAndSqueeze = vec4(height, 0.0, 0.0, 0.0);
#ifdef DEFORMED
  bulgeAndSqueeze.yzw = vec3(projection.along, projection.factor);
#endif

  float margin = (0.5 * max(1.0, greatest) + 0.5) / size;
  float tip = 2.0 * (1.0 + margin);
  float base = cos(halfAngle) - margin;
  int number = gl_VertexID % 3;
  vec2 point = number == 0 ? vec2(tip, 0.0) : vec2(base, (number == 1 ? SLOPE : -SLOPE) * (tip - base));
  vec2 beside = mat2(frame.xy, vec2(-frame.y, frame.x)) * point;
  besideAndZ = vec3(beside, centre.z + viewHeight(lobe.z, lobe.xy + lobe.w * beside) * radius);
  gl_Position = clipAt(viewPoint(lobe.xy + lobe.w * beside) * radius);
  gl_Position.z = 0.0;
}
