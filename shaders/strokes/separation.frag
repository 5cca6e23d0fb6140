precision highp float;
precision highp int;

// The separation of a lobe from the smoke behind it at each sample of its arc, 0..1, and other texels of its tile.
flat in int arc;

out vec4 result;

#include arc.glsl
#include separation.glsl

void main() {
  int number = numberOf(arc, gl_FragCoord.xy);
  fetchArc(arc);
  float opacity = findArc();
  if (number <= LAST) result = vec4(separationAt(alongOf(number), 1));
  else if (number == OPACITY_TEXEL) result = vec4(opacity);
  else if (number == REACH_TEXEL) result = vec4(REACH_OF_ARC / max(REACH / arcLength, REACH_OF_ARC));
  else result = vec4(1.0);
}
