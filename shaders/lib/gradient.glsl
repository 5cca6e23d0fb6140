// World height at which a gradient by height begins, metres, and 1 / its extent; 0 for other gradients.
uniform vec2 heights;
uniform mat4 viewFromWorld;

// Where a fragment lies along the gradient, 0 to 1. `flatPosition` is that of gradients that the relief does not change, and
// 0 for one by height, which is taken at the place that the fragment shows. Needs pixel.glsl, clipFromView and viewport.
float gradientAt(float flatPosition, float viewZ) {
  vec4 shown = vec4(viewPointOf(gl_FragCoord.xy, clipFromView, viewport, viewZ), viewZ, 1.0) - viewFromWorld[3];
  return clamp(flatPosition + (dot(viewFromWorld[1], shown) - heights.x) * heights.y, 0.0, 1.0);
}
