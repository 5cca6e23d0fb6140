precision highp float;

// Chooses between the lit and the unlit colour by the shadow mask, in screen space. Output: display-encoded colour,
// premultiplied only if no pass follows.
uniform sampler2D unlit;
uniform sampler2D lit;
uniform vec3 deepShadow;
// Whether this is the last pass. The page expects premultiplied colours.
uniform bool isLast;

layout(location = 0) out vec4 pixel;

#include ../lib/mask.glsl

#ifdef AMOUNTS
void printSurface(vec4 shadowed, vec4 direct, float shadow);
#endif

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 shadowed = texelFetch(unlit, at, 0);
  vec4 direct = texelFetch(lit, at, 0);
#ifdef AMOUNTS
  printSurface(shadowed, direct, float(isShadowed(direct.a)));
#endif
  if (isDeep(direct.a)) shadowed.rgb *= deepShadow;
  vec3 tone = isShadowed(direct.a) ? shadowed.rgb : direct.rgb;
  pixel = vec4(isLast ? tone * shadowed.a : tone, shadowed.a);
}
