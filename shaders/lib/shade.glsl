// The two colours of a pixel: in shadow and in the light.
struct Shades {
  vec3 unlit;
  vec3 lit;
};

// N . towardsFill from which the fill light shows.
const float FILL_BORDER = 0.65;

// Where the light comes from that fills shadows: on the other side of the eye than the key light and a little from
// below, as in a studio. There shadows are seen. View space.
vec3 towardsFill(vec3 towardsLight) {
  return normalize(vec3(-towardsLight.x, -0.4 * towardsLight.y, max(0.3, abs(towardsLight.z))));
}

// A band along the silhouette, broadest where the surface looks away from the light; it ends where the light begins.
// A width of 1 is a band of half the radius of a ball.
bool isRim(float facingEye, float facingLight, float width) {
  float band = 0.5 * width * clamp(0.5 - facingLight, 0.0, 1.0);
  return band > 0.0 && facingEye < sqrt(band * (2.0 - band));
}

// Eq. 2 of McGuire and Fein (2006), its quantisation q folded into rows of final colours, see src/device/ramps.ts. Takes
// unit vectors in view space; a material without fill and rim may have them in any. Where a surface looks away from the
// light both colours are the same, so that no edge shows there: rows begin with the same tone, fill and rim belong to
// both. `rim` is its colour and its width.
Shades shade(vec3 normal, vec3 towardsLight, sampler2D ramps, float material, vec3 gradient, vec4 rim) {
  float facing = dot(normal, towardsLight);
  if (isRim(normal.z, facing, rim.a)) return Shades(rim.rgb, rim.rgb);
  float pitch = 1.0 / float(textureSize(ramps, 0).y);
  float row = (4.0 * material + (dot(normal, towardsFill(towardsLight)) > FILL_BORDER ? 2.5 : 0.5)) * pitch;
  vec3 unlit = textureLod(ramps, vec2(facing, row), 0.0).rgb * gradient;
  vec3 lit = textureLod(ramps, vec2(facing, row + pitch), 0.0).rgb * gradient;
  return Shades(unlit, lit);
}
