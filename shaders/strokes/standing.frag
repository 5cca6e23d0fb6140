precision highp float;
precision highp int;

// How well a lobe stands before other smoke at each sample of its arc, 0..1, and other texels of its tile.
flat in int arc;

out vec4 result;

#include arc.glsl
#include standing.glsl

void main() {
  int number = numberOf(arc, gl_FragCoord.xy);
  fetchArc(arc);
  float opacity = findArc();
  if (number <= LAST) result = vec4(standing(alongOf(number), 1));
  else if (number == OPACITY_TEXEL) result = vec4(opacity);
  else if (number == REACH_TEXEL) result = vec4(REACH_OF_ARC / max(REACH / arcLength, REACH_OF_ARC));
  else result = vec4(1.0);
}
