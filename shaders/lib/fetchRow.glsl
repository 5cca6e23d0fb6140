// Rows of the simulator: src/device/drawnRows.ts. Call fetchRow first.
uniform highp sampler2D rowPlaces;
uniform highp usampler2D rowAttributes;

// World position and radius.
vec4 place;
// See attributes.glsl.
uvec4 attributes;

void fetchRow(int row) {
  int perLine = textureSize(rowPlaces, 0).x;
  ivec2 texel = ivec2(row % perLine, row / perLine);
  place = texelFetch(rowPlaces, texel, 0);
  attributes = texelFetch(rowAttributes, texel, 0);
}

// The air around the camera is clear: puffs shrink as the camera moves into them, with their lines and shadows. The share
// depends on the distance from the camera alone, so it is the same wherever the camera looks.
float clearance(vec3 centre, float greatestRadius, mat4 clipFromView, float near) {
  bool perspective = clipFromView[2][3] != 0.0;
  float beyondNear = perspective ? length(centre) - near : abs(centre.z + near);
  return smoothstep(0.0, 2.0 * greatestRadius, beyondNear);
}
