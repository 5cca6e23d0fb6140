// World transforms of the surfaces and of the rows of the skin, a row of four texels for each: src/renderer/passes/surfaceTransforms.ts.
uniform highp sampler2D transforms;

mat4 worldFromModel(int surface) {
  return mat4(
    texelFetch(transforms, ivec2(0, surface), 0),
    texelFetch(transforms, ivec2(1, surface), 0),
    texelFetch(transforms, ivec2(2, surface), 0),
    texelFetch(transforms, ivec2(3, surface), 0)
  );
}
