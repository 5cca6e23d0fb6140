precision highp float;

// Writes a depth different from that of the polygon, and may discard, as the bodies do.
uniform float minTone;

flat in float writtenDepth;
flat in float shown;

out vec4 pixel;

void main() {
  if (shown < minTone) discard;
  pixel = vec4(shown);
  gl_FragDepth = writtenDepth;
}
