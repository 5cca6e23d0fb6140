// The two colours of a pixel: in shadow and in the light.
struct Shades {
  vec3 unlit;
  vec3 lit;
};

// Eq. 2 of McGuire and Fein (2006), its quantisation q folded into rows of final colours. Normal and light are unit
// vectors of one space; `rows` are those in shadow and in the light. Both begin with the same tone, so that no
// edge shows where a surface turns from the light.
Shades shade(vec3 normal, vec3 towardsLight, sampler2D ramps, vec2 rows, vec3 fill) {
  float facing = dot(normal, towardsLight);
  vec3 unlit = textureLod(ramps, vec2(facing, rows.x), 0.0).rgb * fill;
  vec3 lit = textureLod(ramps, vec2(facing, rows.y), 0.0).rgb * fill;
  return Shades(unlit, lit);
}
