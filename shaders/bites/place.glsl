// Places the bites of a puff that dissolves: three balls that grow with its erosion and are cut out of its lobes. Two bites lie
// on opposite sides and leave a cup, then a ring; the third opens the ring to a hook. They turn and stretch like lobes. Where
// `isTorn`, they lie about the axis of the stretch instead, before and behind the puff on opposite sides, and leave tatters along it.

// Centres of the first and of the third bite in the frame of the puff.
const vec3 FIRST_BITE = vec3(0.69, 0.92, 0.0);
const vec3 THIRD_BITE = vec3(0.0, 0.0, 1.25);
// Radii of the bites when they begin, how much they grow, and the erosion at which they begin.
const vec3 BITE_RADII = vec3(0.15, 0.15, 0.25);
const vec3 BITE_GROWTH = vec3(1.08, 1.08, 0.75);
const vec3 BITE_STARTS = vec3(0.0625, 0.2, 0.4);

// The first or the second bite, which is opposite to it, whichever is higher; and the third bite.
flat out vec3 nearBite;
flat out vec3 sideBite;
// The radii of the higher, the lower and the third bite in one number, because some GPUs have no more varyings.
flat out float packedRadii;

// How far a puff is dissolved, 0 to 1.
float erosionOf(uvec4 attributes) {
  return float(attributes.w >> 24u) / 255.0;
}

#ifdef DEFORMED
uniform bool isTorn;

// A vector after the rotation along the shortest arc that turns the x axis to `axis`.
vec3 turnedFromX(vec3 axis, vec3 vector) {
  vec3 across = vec3(0.0, -axis.z, axis.y);
  vec3 turned = cross(across, vector);
  return vector + turned + cross(across, turned) / max(1.0 + axis.x, 1e-4);
}
#endif

// The centres of the first and of the third bite in another frame.
mat2x3 bitesIn(mat3 frameFromPuff) {
#ifdef DEFORMED
#ifdef LOOKS
  bool isTorn = isTornPuff(attributes);
#endif
  if (isTorn) {
    vec3 axis = normalize(stretchOf(attributes.w).xyz * worldFromPuff(attributes));
    return mat2x3(frameFromPuff * turnedFromX(axis, FIRST_BITE), frameFromPuff * turnedFromX(axis, THIRD_BITE));
  }
#endif
  return mat2x3(frameFromPuff * FIRST_BITE, frameFromPuff * THIRD_BITE);
}

// Writes the outputs for the centres of the first and of the third bite. Returns their radii.
vec3 placeBites(mat2x3 bites, float scale) {
  const vec3 PLACES = vec3(1.0, 256.0, 65536.0);
  vec3 grown = max((erosionOf(attributes) - BITE_STARTS) / (1.0 - BITE_STARTS), 0.0);
  vec3 radii = sign(grown) * scale * (BITE_RADII + BITE_GROWTH * grown * (2.0 - grown));
  nearBite = bites[0];
  sideBite = bites[1];
  if (nearBite.z < 0.0) {
    nearBite = -nearBite;
    radii.xy = radii.yx;
  }
  packedRadii = dot(floor(200.0 * radii + 0.5), PLACES);
  return radii;
}
