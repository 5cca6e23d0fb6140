// The projection of the points that a pixel shows, without the terms of an oblique near plane: those are constant along a
// view ray.
mat4 withoutSlant(mat4 clipFromView, vec2 ndc) {
  vec2 slant = vec2(clipFromView[0][2], clipFromView[1][2]) / vec2(clipFromView[0][0], clipFromView[1][1]);
  mat4 straight = clipFromView;
  straight[2][2] += dot(slant, ndc * clipFromView[2][3] - clipFromView[2].xy);
  straight[3][2] += dot(slant, ndc * clipFromView[3][3] - clipFromView[3].xy);
  return straight;
}
