// A near tree: twigs fray the rim of each tier, snow lies on its branches. A larch has twigs without needles.
in vec3 light;
in vec3 air;
in vec2 place;
flat in vec3 green;
flat in vec4 white;
flat in vec2 kind;
out vec4 colour;

float wave(float x) { return abs(2.0 * fract(x) - 1.0); }

void main() {
    if (kind.y < 0.0) {
        colour = vec4(green * light + air, 0.0);
        return;
    }
    // Across the branches, spread out toward the rim.
    float side = floor(place.x), across = (fract(place.x) - 0.5) / max(place.y, 0.05);
    float twigs = 0.6 * wave(across * 2.0 + 0.31 * side + kind.x) + 0.4 * wave(across * 5.3 + 0.77 * side + 3.1 * kind.x);
    if (place.y > 0.70 + 0.34 * twigs) discard;
    if (kind.y < 1.0 && wave(across * 4.0 + 1.7 * place.y + kind.x) > kind.y + 0.25 * (1.0 - place.y)) discard;
    // Snow lies in pads on the branches, broken where twigs are.
    float lump = 0.55 * wave(across * 2.6 + 0.43 * side + kind.x) + 0.45 * wave(across * 6.1 + 2.7 * place.y + 5.0 * kind.x);
    float pad = abs(place.y - 0.66 + 0.16 * wave(1.3 * across + kind.x));
    float snowy = white.a * smoothstep(0.30, 0.62, lump - 2.3 * pad + 0.20 * white.a);
    vec3 shade = gl_FrontFacing ? vec3(0.40 + 0.75 * place.y * (0.35 + 0.65 * twigs)) : vec3(0.30);
    vec3 albedo = gl_FrontFacing ? mix(green * shade, white.rgb, 0.75 * snowy) : green * shade;
    colour = vec4(albedo * light + air, 0.0);  // alpha 0: edges_mark.frag leaves it out
}
