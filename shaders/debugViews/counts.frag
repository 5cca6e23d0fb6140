precision highp float;

// Shows a count, stored in the red channel in units of 1/255, as a heat map: black for 0, red for 1, then yellow and
// white. The macro RATE is the steepness: half of the way to white is reached at about 1 / RATE.
uniform sampler2D unlit;

out vec4 pixel;

void main() {
  float number = round(255.0 * texelFetch(unlit, ivec2(gl_FragCoord.xy), 0).r);
  float heat = 3.0 * (1.0 - exp2(-RATE * (number + step(0.5, number))));
  pixel = vec4(clamp(vec3(heat, heat - 1.0, heat - 2.0), 0.0, 1.0), 1.0);
}
