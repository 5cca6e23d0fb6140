precision highp float;

// Writes nothing: the stencil operations count.
void main() {}
