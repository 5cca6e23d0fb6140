precision highp float;
precision highp int;

// How well a lobe stands before other smoke at each sample of its arc, 0..1. Other texels of the tile are 1.
flat in int arc;

out vec4 result;

#include arc.glsl
#include standing.glsl

void main() {
  int number = numberOf(arc, gl_FragCoord.xy);
  fetchArc(arc);
  findArc();
  result = vec4(number > LAST ? 1.0 : standing(alongOf(number), 1));
}
