// Size of a pixel of the target in view units, at a view-space z. The viewport is in pixels.
float viewUnitsPerPixel(mat4 clipFromView, vec2 viewport, float viewZ) {
  float clipW = clipFromView[2][3] * viewZ + clipFromView[3][3];
  return 2.0 * clipW / (clipFromView[1][1] * viewport.y);
}

// The view-space xy at which the view ray through a pixel has a view-space z.
vec2 viewPointOf(vec2 pixel, mat4 clipFromView, vec2 viewport, float viewZ) {
  vec2 clip = (pixel / viewport * 2.0 - 1.0) * (clipFromView[2][3] * viewZ + clipFromView[3][3]);
  return (clip - clipFromView[2].xy * viewZ - clipFromView[3].xy) / vec2(clipFromView[0][0], clipFromView[1][1]);
}
