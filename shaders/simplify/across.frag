precision highp float;
precision highp int;

// The first half of the smoothing, along rows. Output: the averaged fields and shares of lights.
layout(location = 0) out vec4 field;
#ifdef ADDITIONAL_LIGHTS
layout(location = 1) out vec4 lights;
#endif

#include smoothing.glsl

void main() {
  field = smoothedAt(ivec2(gl_FragCoord.xy), ivec2(1, 0), LINKED_RIGHT);
#ifdef ADDITIONAL_LIGHTS
  lights = vec4(lightShares, 1.0);
#endif
}
