// How the light falls on a pixel. Needs srgb.glsl.
struct Lighting {
  float facing;
  bool isFilled;
  bool isRim;
};

// The two colours of a pixel, in shadow and in the light.
struct Shades {
  vec3 unlit;
  vec3 lit;
};

// N . towardsFill above which the fill light applies.
const float FILL_BORDER = 0.65;
// Rows of a material: in shadow, in the light, then both again where the fill light applies.
const float RAMP_ROWS = 4.0;
const float RAMP_TEXELS = 256.0;

// Direction of the fill light in view space: on the opposite side of the camera from the key light and slightly from
// below, where shadows are visible, as in studio lighting.
vec3 towardsFill(vec3 towardsLight) {
  return normalize(vec3(-towardsLight.x, -0.4 * towardsLight.y, max(0.3, abs(towardsLight.z))));
}

// Whether a point is in the rim band along the silhouette. The band is widest where the surface faces away from the
// light and ends where the light begins. With a width of 1 it is half the radius of a sphere.
bool isRim(float facingEye, float facingLight, float width) {
  float band = 0.5 * width * clamp(0.5 - facingLight, 0.0, 1.0);
  return band > 0.0 && facingEye < sqrt(band * (2.0 - band));
}

// Linear colour of the rim in the light of the style.
uniform vec3 rimGlow;

#ifdef LOOKS
ivec2 inColumns(ivec2 texel);
float withoutLook(float rampIndex);
#endif

// The texel at a place of a row of a material's ramp.
ivec2 rampTexel(float material, float row, float place) {
  ivec2 texel = ivec2(place, RAMP_ROWS * material + row);
#ifdef LOOKS
  texel = inColumns(texel);
#endif
  return texel;
}

// The rim of a material. A share of it glows, see src/renderer/gpu/ramps.ts.
// @param color of the rim in the light
vec3 rimOf(vec3 color, sampler2D ramps, float material) {
  float glow = texelFetch(ramps, rampTexel(material, 0.0, 0.0), 0).a;
  return glow > 0.0 ? displayFromLinear(mix(linearFromDisplay(color), rimGlow, glow)) : color;
}

// Takes unit vectors in view space; a material without fill and rim may use any space.
Lighting lightingOf(vec3 normal, vec3 towardsLight, float rimWidth) {
  float facing = dot(normal, towardsLight);
  bool isFilled = dot(normal, towardsFill(towardsLight)) > FILL_BORDER;
  return Lighting(facing, isFilled, isRim(normal.z, facing, rimWidth));
}

// FALLOFF: src/renderer/falloff.ts adds falloff/falloff.glsl.
#ifdef FALLOFF
void findStrength(vec3 place);
float takeStrength(inout float material);
vec3 inLight(ivec2 texel, bool isRim);
#endif

// ADDITIONAL_LIGHTS: src/renderer/additionalLights.ts adds additionalLights/additionalLights.glsl.
#ifdef ADDITIONAL_LIGHTS
uniform int lightCount;
// Light of those that are beyond the number, from all sides.
uniform vec3 lightAround;
// N.L from which smoke and surfaces are in a light. Light goes around puffs, which are not solid.
const float SMOKE_BORDER = 0.0;
const float SURFACE_BORDER = 0.3;

int lightsOn(vec3 normal, vec3 place, float border);
vec3 sharesOf(int lights);
vec3 leaningShares(vec3 shares, vec3 normal, vec3 place);
vec3 lightOf(vec3 shares, vec3 place);
vec3 reflected(float material, vec3 sum);
vec3 lightened(vec3 tone, vec3 light);
#endif

// Eq. 2 of McGuire and Fein (2006), with its quantisation q folded into rows of final colours, see src/renderer/gpu/ramps.ts.
// Both colours are equal on the side away from the light, so that no edge is visible there: rows start with the same tone,
// and fill and rim apply to both.
Shades shade(Lighting light, sampler2D ramps, float material, vec3 gradient, vec3 rimColor) {
  float column = clamp(light.facing * RAMP_TEXELS, 0.0, RAMP_TEXELS - 1.0);
  ivec2 texel = rampTexel(material, light.isFilled ? 2.0 : 0.0, column);
#ifdef FALLOFF
  vec3 lit = inLight(texel + ivec2(0, 1), light.isRim);
  rimColor = lit;
#else
  vec3 lit = texelFetch(ramps, texel + ivec2(0, 1), 0).rgb;
#endif
  if (light.isRim) {
    vec3 rim = rimOf(rimColor, ramps, material);
    return Shades(rim, rim);
  }
  return Shades(texelFetch(ramps, texel, 0).rgb * gradient, lit * gradient);
}
