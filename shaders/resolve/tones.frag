precision highp float;

// Chooses between lit and unlit by the mask.
uniform sampler2D unlit;
uniform sampler2D lit;
uniform vec3 deepShadow;
// Takes all that is not ink to be in deep shadow, whatever the mask says.
uniform bool isAllDeep;
// Whether nothing comes after this: the page takes colours premultiplied.
uniform bool isLast;

out vec4 pixel;

// Around 3/4, which the mask says of deep shadow; 1/2 or 1 is plain shadow.
const vec2 DEEP = vec2(0.625, 0.875);

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 shadowed = texelFetch(unlit, at, 0);
  vec4 direct = texelFetch(lit, at, 0);
  // Ink holds 1 from the start, and is the same in every light.
  bool isDeep = isAllDeep ? direct.a < DEEP.y : direct.a > DEEP.x && direct.a < DEEP.y;
  if (isDeep) shadowed.rgb *= deepShadow;
  vec3 tone = isAllDeep || direct.a > 0.25 ? shadowed.rgb : direct.rgb;
  pixel = vec4(isLast ? tone * shadowed.a : tone, shadowed.a);
}
