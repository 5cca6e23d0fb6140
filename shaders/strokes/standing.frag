precision highp float;

in float shown;

out vec4 standing;

void main() {
  standing = vec4(shown);
}
