// Cuts bites out of the part of a line that is in a lobe. Places on the line increase towards the eye or away from the light.

const float NO_BITE = -1e8;
const float STEEP = 1e6;

// Where the line leaves and enters the bites. Their middles decrease: then a bite that was passed is not entered again.
vec3 bitesEnd;
vec3 bitesStart;

// The end and the start of a bite, by its middle and the square of half of its extent, at most 0 where it is missed.
vec2 biteOf(float middle, float squared) {
  float halfExtent = sqrt(max(squared, 0.0));
  return vec2(squared > 0.0 ? middle + halfExtent : NO_BITE, middle - halfExtent);
}

// The nearest place before this one or at it that is in no bite. Arithmetic, because it takes less than a choice.
float uncut(float place) {
  place = min(place, max(bitesStart.x, STEEP * (place - bitesEnd.x)));
  place = min(place, max(bitesStart.y, STEEP * (place - bitesEnd.y)));
  return min(place, max(bitesStart.z, STEEP * (place - bitesEnd.z)));
}
