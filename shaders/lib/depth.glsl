// 1 if window depth increases away from the camera; -1 with reversed depth, which is 1 at the near plane and 0 at the
// far plane.
float depthOrder(mat4 clipFromView) {
  return clipFromView[3][2] > 0.0 ? -1.0 : 1.0;
}

// Depth of a view-space z in normalised device coordinates, for any three.js projection (perspective, off-axis,
// orthographic, each with reversed depth or not). Only the third and fourth rows of the matrix matter.
float ndcDepth(mat4 clipFromView, float viewZ) {
  float clipZ = clipFromView[2][2] * viewZ + clipFromView[3][2];
  float clipW = clipFromView[2][3] * viewZ + clipFromView[3][3];
  return clipZ / clipW;
}

// Window depth in [0, 1] of a view-space z.
float windowDepth(mat4 clipFromView, float viewZ) {
  float ndc = ndcDepth(clipFromView, viewZ);
  return depthOrder(clipFromView) < 0.0 ? ndc : 0.5 * ndc + 0.5;
}

// The view-space z of a window depth: the inverse of windowDepth. That of an infinite far plane is finite.
float viewZOf(mat4 clipFromView, float depth) {
  float ndc = depthOrder(clipFromView) < 0.0 ? depth : min(2.0 * depth - 1.0, 0.9999999);
  return (ndc * clipFromView[3][3] - clipFromView[3][2]) / (clipFromView[2][2] - ndc * clipFromView[2][3]);
}
