// The projection of the points that a pixel shows, without the terms of an oblique near plane: along a view ray they are
// linear. Needs pixel.glsl.
mat4 withoutSlant(vec2 pixel, mat4 clipFromView, vec2 viewport) {
  vec2 slant = vec2(clipFromView[0][2], clipFromView[1][2]);
  vec2 start = viewPointOf(pixel, clipFromView, viewport, 0.0);
  clipFromView[2][2] += dot(slant, viewPointOf(pixel, clipFromView, viewport, 1.0) - start);
  clipFromView[3][2] += dot(slant, start);
  return clipFromView;
}
