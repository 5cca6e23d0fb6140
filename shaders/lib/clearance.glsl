// The air around the camera is clear: puffs shrink as the camera moves into them, with their lines and shadows. The share
// depends on the distance from the camera alone, so it is the same wherever the camera looks. `across`: acrossOf the stretch.
// Needs rows.glsl, clipFromView and near.
float clearance(vec3 centre, float across) {
  float beyondNear = clipFromView[2][3] == 0.0 ? abs(centre.z + near) : length(centre) - near;
  return smoothstep(0.0, 2.0 * place.w / across, beyondNear);
}
