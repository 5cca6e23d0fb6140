precision highp float;

// Scales a picture to the size of the canvas. Its colours are premultiplied, so filtering blends them correctly.
uniform sampler2D picture;
uniform vec2 canvas;

out vec4 pixel;

void main() {
  pixel = textureLod(picture, gl_FragCoord.xy / canvas, 0.0);
}
