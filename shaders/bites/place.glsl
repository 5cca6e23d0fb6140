// The bites of a puff that dissolves: three balls that grow with its erosion and are cut out of its lobes. The near and the
// far bite lie on opposite sides and leave a cup, then a ring; the side bite opens the ring to a hook. They turn and stretch
// like lobes.

// Distance of the first two bites and of the third from the centre, in puff radii.
const vec2 BITE_DISTANCES = vec2(1.15, 1.25);
// Erosion at which the second and the third bite begin.
const vec2 BITE_STARTS = vec2(0.2, 0.4);
// How far the first two bites and the third have grown when the erosion is 1.
const vec2 BITE_DEPTHS = vec2(1.08, 0.75);
// Erosion up to which the start of the shadow moves behind the puff and no bite has reached it.
const float EROSION_LEAD = 0.0625;

// How far a puff is dissolved, 0 to 1.
float erosionOf(uvec4 attributes) {
  return float(attributes.w >> 24u) / 255.0;
}

// Centres of the first and of the third bite in the frame of the puff. The second is opposite to the first.
vec3 firstBite(int variation) {
  const float GOLDEN_ANGLE = 2.399963229728653;
  float angle = GOLDEN_ANGLE * float(variation);
  return BITE_DISTANCES.x * vec3(0.6 * cos(angle), 0.8, 0.6 * sin(angle));
}

vec3 sideBite(int variation) {
  const float GOLDEN_ANGLE = 2.399963229728653;
  float angle = GOLDEN_ANGLE * float(variation);
  return BITE_DISTANCES.y * vec3(-sin(angle), 0.0, cos(angle));
}

// Radii of the first, the second and the third bite; 0 for none.
vec3 biteRadii(float erosion) {
  vec3 starts = vec3(EROSION_LEAD, BITE_STARTS);
  vec3 grown = (vec3(erosion) - starts) / (1.0 - starts);
  vec3 radii = BITE_DISTANCES.xxy - 1.0 + BITE_DEPTHS.xxy * grown * (2.0 - grown);
  return mix(vec3(0.0), radii, greaterThan(grown, vec3(0.0)));
}
