precision highp float;
precision highp int;

// A point over the tile of each arc that has samples.
uniform sampler2D separations;

flat out int arc;

#include tile.glsl
#include placeTile.glsl

void main() {
  arc = gl_VertexID;
  placeTile(arc, texelFetch(separations, texelOf(arc, LAST_TEXEL), 0).r > 0.0);
}
