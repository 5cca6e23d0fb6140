// The shadow mask in the alpha of the lit colour, as src/renderer/passes/mask.ts writes it: 0 in the light, 1/2 or 1 in shadow,
// 3/4 in deep shadow. Ink has 1 from the start and is the same in all light.
const vec2 DEEP = vec2(0.625, 0.875);

bool isShadowed(float mask) {
  return mask > 0.25;
}

bool isDeep(float mask) {
  return mask > DEEP.x && mask < DEEP.y;
}

// Before the mask is drawn: everything but ink has 0.
bool isInk(float mask) {
  return mask > DEEP.y;
}
