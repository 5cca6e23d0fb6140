// How the light falls on a pixel of smoke, 8 bits a channel: N.L; material, low byte; material, high bits, and flags;
// radius of the puff, on a logarithmic scale, and 0 where there is no smoke.
struct Shading {
  float facing;
  float material;
  bool isFilled;
  bool isRim;
  bool isInk;
  float radius;
};

// Materials are below 4096: at most 16 by 16 bands, the tints and the surfaces.
const float MATERIALS_HIGH = 16.0;
// Range of the base 2 logarithm of the radius, metres.
const vec2 LOG_RADII = vec2(-10.0, 6.0);

vec4 packShading(Shading shading) {
  float flags = float(shading.isFilled) + 2.0 * float(shading.isRim) + 4.0 * float(shading.isInk);
  float high = floor(shading.material / 256.0);
  float size = (log2(shading.radius) - LOG_RADII.x) / (LOG_RADII.y - LOG_RADII.x);
  vec3 bytes = vec3(shading.material - 256.0 * high, MATERIALS_HIGH * high + flags, max(1.0, 255.0 * size));
  return vec4(shading.facing, bytes / 255.0);
}
