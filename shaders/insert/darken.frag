precision highp float;

// Multiplies the host's picture where its shadow is deep. Screen space; the blend function uses the output as a factor.
// `factor` is the multiplier of the colour of shadow.
uniform vec3 factor;

out vec4 pixel;

void main() {
  pixel = vec4(factor, 1.0);
}
