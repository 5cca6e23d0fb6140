precision highp float;

// Chooses between the lit and the unlit colour by the shadow mask, in screen space. Output: display-encoded colour,
// premultiplied only if no pass follows.
uniform sampler2D unlit;
uniform sampler2D lit;
uniform vec3 deepShadow;
// Treats everything except ink as in deep shadow, whatever the mask is.
uniform bool isAllDeep;
// Whether this is the last pass. The page expects premultiplied colours.
uniform bool isLast;

out vec4 pixel;

// Range around 3/4, the mask of deep shadow; 1/2 or 1 is plain shadow.
const vec2 DEEP = vec2(0.625, 0.875);

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 shadowed = texelFetch(unlit, at, 0);
  vec4 direct = texelFetch(lit, at, 0);
  // Ink has 1 from the start and is the same in all light.
  bool isDeep = isAllDeep ? direct.a < DEEP.y : direct.a > DEEP.x && direct.a < DEEP.y;
  if (isDeep) shadowed.rgb *= deepShadow;
  vec3 tone = isAllDeep || direct.a > 0.25 ? shadowed.rgb : direct.rgb;
  pixel = vec4(isLast ? tone * shadowed.a : tone, shadowed.a);
}
