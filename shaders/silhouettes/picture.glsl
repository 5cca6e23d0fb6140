// Alpha is 0.5 plus the signed distance to the silhouette, negative inside, over the range of distances.
uniform highp sampler2DArray silhouettes;

flat in vec3 pictureAxis;

// The same alpha at a point of the plane of the discs. From the finest level, because neighbouring receivers may be far apart.
float alphaAt(vec2 point) {
  vec2 place = vec2(dot(pictureAxis.xy, point), pictureAxis.y * point.x - pictureAxis.x * point.y);
  return textureLod(silhouettes, vec3(0.5 + place, pictureAxis.z), 0.0).a;
}
