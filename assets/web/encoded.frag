// Encodes what a fragment shader before it has written, as screens have it.
#undef main
void main() {
    linear_main();
    vec3 c = clamp(colour.rgb, 0.0, 1.0);
    colour.rgb = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}
