precision highp float;

// What a picture is multiplied by where its shadow is deep.
uniform vec3 factor;

out vec4 pixel;

void main() {
  pixel = vec4(factor, 1.0);
}
