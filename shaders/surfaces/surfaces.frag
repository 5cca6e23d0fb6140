precision highp float;

// The meshes of the scene, each shaded by its own rows of the ramp texture. Inputs are in world space. Outputs the
// display-encoded unlit and lit colour and, for targets that keep it, the number of the group over 255.
uniform sampler2D ramps;
uniform vec4 lightInWorld;
#define LIGHTS_IN_WORLD

in vec3 worldNormal;
in vec3 worldPlace;
flat in float material;
flat in float group;

layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 lit;
layout(location = 2) out float number;

#include ../lib/light.glsl
#include ../lib/srgb.glsl
#include ../lib/shade.glsl

void main() {
  vec3 towardsLight = towardsLightFrom(lightInWorld, worldPlace);
  Lighting light = lightingOf(normalize(worldNormal), towardsLight, 0.0);
#ifdef FALLOFF
  findStrength(worldPlace);
#endif
  Shades shades = shade(light, ramps, material, vec3(1.0), vec3(0.0));
#ifdef ADDITIONAL_LIGHTS
  int lights = lightsOn(normalize(worldNormal), worldPlace, SURFACE_BORDER);
  vec3 sum = lightOf(sharesOf(lights), worldPlace);
  if (sum != vec3(0.0)) {
    vec3 added = reflected(material, sum);
    vec3 brightened = lightened(shades.lit, added);
    // Both are equal on the side away from the key light.
    shades = Shades(shades.unlit == shades.lit ? brightened : lightened(shades.unlit, added), brightened);
  }
#endif
  unlit = vec4(shades.unlit, 1.0);
  lit = vec4(shades.lit, 0.0);
  number = group / 255.0;
}
