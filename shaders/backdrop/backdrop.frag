precision highp float;

// The background: opaque display-encoded colours at heights of the picture, blended between them. Shadows do not darken
// it, so lit and unlit are equal. STOPS is the capacity of `stops`.
uniform vec4 stops[STOPS];  // colour, height 0..1
uniform int stopCount;
uniform vec2 viewport;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;
// Number of the group of a surface, see shaders/surfaces/surfaces.frag.
layout(location = 2) out float number;

void main() {
  float height = gl_FragCoord.y / viewport.y;
  vec3 color = stops[0].rgb;
  for (int stop = 1; stop < stopCount; ++stop) {
    float from = stops[stop - 1].a;
    color = mix(color, stops[stop].rgb, clamp((height - from) / (stops[stop].a - from), 0.0, 1.0));
  }
  unlit = vec4(color, 1.0);
  lit = vec4(color, 0.0);
  number = 0.0;
}
