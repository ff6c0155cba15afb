// Writes depth only. The surface is shaded later, once per pixel, from its depth.
void main() {}
