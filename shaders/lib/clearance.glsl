// Share of its size with which a puff is drawn: it shrinks as the camera moves into it, with its lines and its shadow. The
// share depends on the distance from the camera alone, not on its direction. `across`: acrossOf the stretch.
// Needs rows.glsl, clipFromView and near.
float clearance(vec3 centre, float across) {
  float beyondNear = clipFromView[2][3] == 0.0 ? abs(centre.z + near) : length(centre) - near;
  return smoothstep(0.0, 2.0 * place.w / across, beyondNear);
}
