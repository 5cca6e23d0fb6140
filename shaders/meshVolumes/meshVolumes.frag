precision highp float;

// No output: the stencil operations count.
void main() {}
