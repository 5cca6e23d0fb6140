precision highp float;

// A rectangle in clip space with two depths: its own and the one that its fragments write.
in vec2 place;
in vec2 depths;
in float tone;

flat out float writtenDepth;
flat out float shown;

void main() {
  writtenDepth = depths.y;
  shown = tone;
  gl_Position = vec4(place, depths.x, 1.0);
}
