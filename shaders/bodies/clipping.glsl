// Planes in view space: `renderer.clippingPlanes` of three.js. MAX_PLANES in src/renderer/gpu/frameView.ts is their maximum.
uniform vec4 clippingPlanes[8];
uniform int planeCount;

// Whether a plane cuts off what a pixel shows at a window depth. Needs depth.glsl and pixel.glsl.
bool isCutOff(mat4 clipFromView, vec2 viewport, float depth) {
  for (int i = 0; i < planeCount; i++) {
    float z = viewZOf(clipFromView, depth);
    if (dot(clippingPlanes[i], vec4(viewPointOf(gl_FragCoord.xy, clipFromView, viewport, z), z, 1.0)) < 0.0) return true;
  }
  return false;
}
