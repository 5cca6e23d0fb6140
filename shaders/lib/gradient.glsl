// World height at which a gradient by height starts, metres, and 1 / its extent; the second is 0 for other gradients.
uniform vec2 heights;
uniform mat4 viewFromWorld;

// Position of a fragment along the gradient, 0 to 1. `flatPosition` is that of gradients that do not depend on the
// relief; it is 0 for a gradient by height, which uses the world height of the visible point. Needs pixel.glsl,
// clipFromView and viewport.
float gradientAt(float flatPosition, float viewZ) {
  vec4 shown = vec4(viewPointOf(gl_FragCoord.xy, clipFromView, viewport, viewZ), viewZ, 1.0) - viewFromWorld[3];
  return clamp(flatPosition + (dot(viewFromWorld[1], shown) - heights.x) * heights.y, 0.0, 1.0);
}
