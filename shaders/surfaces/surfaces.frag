precision highp float;

// An ordinary mesh, shaded by its own two rows of the ramps: (Eq. 2 of McGuire and Fein 2006, folded into final tones).
uniform sampler2D ramps;
uniform float litRow;
uniform float unlitRow;
uniform vec3 towardsLight;

in vec3 worldNormal;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  float facing = dot(normalize(worldNormal), towardsLight);
  unlit = vec4(textureLod(ramps, vec2(facing, unlitRow), 0.0).rgb, 1.0);
  lit = vec4(textureLod(ramps, vec2(facing, litRow), 0.0).rgb, 0.0);
}
