// A tree that is some pixels high: branches jut out at its edges and carry snow.
noperspective in vec2 place;
noperspective in vec3 light;
flat in vec3 air;
flat in vec4 green;
flat in vec4 white;
flat in float jagged;
out vec4 colour;

void main() {
    float left = 1.0 - place.y, side = abs(place.x);
    float branch = fract(left * green.w + 0.25 * side + step(0.0, place.x) * 0.37);  // 0 at its top, 1 at its tip
    if (side > left * mix(0.80, 0.58 + 0.42 * branch, jagged)) discard;
    float snowy = white.a * mix(0.24, 0.72 * smoothstep(0.38, 0.80, branch) * step(branch, 0.93), jagged);
    vec3 albedo = mix(green.rgb * mix(1.0, 0.55 + 0.75 * branch, jagged), white.rgb, snowy * (0.75 + 0.25 * left));
    colour = vec4(albedo * light + air, 1.0);
}
