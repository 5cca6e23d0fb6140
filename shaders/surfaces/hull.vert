precision highp float;

// The ink of a surface: its back faces, pushed outwards on the screen by the width of the line.
// Stays constant in pixels at any distance, for perspective and orthographic cameras alike.
uniform mat4 modelMatrix;
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec2 viewport;
uniform float inkPixels;

in vec3 position;
in vec3 hullNormal;

void main() {
  mat4 viewFromModel = viewFromWorld * modelMatrix;
  vec4 clip = clipFromView * viewFromModel * vec4(position, 1.0);
  vec2 outward = vec2(clipFromView[0][0], clipFromView[1][1]) * (mat3(viewFromModel) * hullNormal).xy * viewport;
  float length2 = dot(outward, outward);
  vec2 pixels = length2 > 1e-12 ? outward * (inkPixels * inversesqrt(length2)) : vec2(0.0);
  clip.xy += pixels * 2.0 / viewport * clip.w;
  gl_Position = clip;
}
