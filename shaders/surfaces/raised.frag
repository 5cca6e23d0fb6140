precision highp float;

// The flat colour of a raised hull, except where the nearest surface is one of its own group. Writes the colours as
// hull.frag does.
uniform vec3 inkColor;
// Number of the group of the nearest surface, over 255.
uniform highp sampler2D groups;

flat in float group;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;

void main() {
  float number = 255.0 * texelFetch(groups, ivec2(gl_FragCoord.xy), 0).r;
  if (abs(number - group) < 0.5) discard;
  unlit = vec4(inkColor, 1.0);
  lit = vec4(inkColor, 1.0);
}
