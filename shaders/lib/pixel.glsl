// View units that one pixel of the target spans at a view-space z. The viewport is in pixels.
float viewUnitsPerPixel(mat4 clipFromView, vec2 viewport, float viewZ) {
  float clipW = clipFromView[2][3] * viewZ + clipFromView[3][3];
  return 2.0 * clipW / (clipFromView[1][1] * viewport.y);
}
