// Window depth in [0, 1] of a view-space z under any three.js projection (perspective, off-axis, orthographic),
// for the default depth range. Only the third and fourth rows of the matrix matter.
float windowDepth(mat4 clipFromView, float viewZ) {
  float clipZ = clipFromView[2][2] * viewZ + clipFromView[3][2];
  float clipW = clipFromView[2][3] * viewZ + clipFromView[3][3];
  return 0.5 * clipZ / clipW + 0.5;
}

// The view-space z that has a window depth: the inverse of windowDepth.
float viewZOf(mat4 clipFromView, float depth) {
  float ndc = 2.0 * depth - 1.0;
  return (ndc * clipFromView[3][3] - clipFromView[3][2]) / (clipFromView[2][2] - ndc * clipFromView[2][3]);
}
