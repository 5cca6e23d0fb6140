precision highp float;

// Shows one of the two colours of the targets, or other data that passes store in them. The macro VIEW selects the
// view. Screen space; output is premultiplied.
uniform sampler2D unlit;
uniform sampler2D lit;

out vec4 pixel;

// Range around 1/2, the alpha that marks normals.
const vec2 MARKED = vec2(0.25, 0.75);

vec4 litView(vec4 shadowed, vec4 direct) {
  return vec4(direct.rgb * shadowed.a, shadowed.a);
}

vec4 unlitView(vec4 shadowed, vec4 direct) {
  return vec4(shadowed.rgb * shadowed.a, shadowed.a);
}

// Ink has 1 in the alpha of the lit colour until the mask is drawn.
vec4 inkView(vec4 shadowed, vec4 direct) {
  return vec4(vec3(1.0 - direct.a) * shadowed.a, shadowed.a);
}

vec4 normalsView(vec4 shadowed, vec4 direct) {
  bool isMarked = direct.a > MARKED.x && direct.a < MARKED.y;
  vec3 shown = isMarked ? direct.rgb : vec3(0.25 * dot(shadowed.rgb, vec3(0.3, 0.6, 0.1)));
  return vec4(shown * shadowed.a, shadowed.a);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  pixel = VIEW(texelFetch(unlit, at, 0), texelFetch(lit, at, 0));
}
