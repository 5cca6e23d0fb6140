// Added to the vertex shaders with lib/volume.glsl: a billboard throws the silhouette of its picture as if it faced the light.
uniform float pad;

#include support.glsl

// The x axis of the picture on the plane of the discs, over the width of the picture; the layer of the picture.
flat out vec3 pictureAxis;

// Least value of 1 plus the cosine between the light and the direction towards the eye. Below it, the light is straight behind
// the picture, and no way to turn it is the shortest. The culler uses twice the value.
const float LEAST_RISE = 1e-4;

// Writes the output. The picture is turned the shortest way from the eye to the light. The discs do not change.
float writeCut(float cap, mat3 discsFromPuff, vec4 lengthwise, vec3 travel, vec3 centre, mat2 sideAxes) {
  vec3 turned = discsFromPuff[0];
  vec3 back = discsFromPuff[2];
  // 1 - back.z without its rounding.
  float rise = back.z > 0.0 ? dot(back.xy, back.xy) / (1.0 + back.z) : 1.0 - back.z;
  vec2 axis = turned.xy;
  if (rise > LEAST_RISE) axis += turned.z / rise * back.xy;
  int layer = variationOf(attributes) % textureSize(casterTable, 0).y;
  axis = normalize(axis);
  pictureAxis = vec3(0.5 / pad * axis, float(layer));
  mat2 pictureFromDiscs = mat2(axis, axis.y, -axis.x);
  vec2 right = pictureFromDiscs * sideAxes[0];
  vec2 up = pictureFromDiscs * sideAxes[1];
  sides = vec4(-supportOf(-right, layer), -supportOf(-up, layer), supportOf(right, layer), supportOf(up, layer));
  return cap;
}
