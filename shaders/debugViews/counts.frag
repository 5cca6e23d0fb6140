precision highp float;

// A number, held in the red of a colour as 255ths, by its heat: black for none, red for one, then yellow and white.
// RATE says how fast: 1 / RATE is where half of the way to white is done.
uniform sampler2D unlit;

out vec4 pixel;

void main() {
  float number = round(255.0 * texelFetch(unlit, ivec2(gl_FragCoord.xy), 0).r);
  float heat = 3.0 * (1.0 - exp2(-RATE * (number + step(0.5, number))));
  pixel = vec4(clamp(vec3(heat, heat - 1.0, heat - 2.0), 0.0, 1.0), 1.0);
}
