precision highp float;

// Ink with the opacity of the strokes, over the picture. Output: premultiplied display-encoded colour.
uniform sampler2D coverage;
uniform vec3 inkColor;

out vec4 pixel;

void main() {
  float opacity = texelFetch(coverage, ivec2(gl_FragCoord.xy), 0).r;
  if (opacity == 0.0) discard;
  pixel = vec4(inkColor * opacity, opacity);
}
