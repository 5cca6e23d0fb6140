// Added to volumes/volumes.frag.
#include picture.glsl

bool isLeft(vec2 point) {
  return alphaAt(point) < 0.5;
}
