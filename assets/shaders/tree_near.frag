// A near tree: twigs fray the rim of each tier, snow lies on its branches.
in vec3 light;
in vec3 air;
in vec2 place;
flat in vec3 green;
flat in vec4 white;
flat in float kind;
out vec4 colour;

float wave(float x) { return abs(2.0 * fract(x) - 1.0); }

void main() {
    // Across the branches, spread out toward the rim.
    float side = floor(place.x), across = (fract(place.x) - 0.5) / max(place.y, 0.05);
    float twigs = 0.6 * wave(across * 2.0 + 0.31 * side + kind) + 0.4 * wave(across * 5.3 + 0.77 * side + 3.1 * kind);
    if (place.y > 0.74 + 0.30 * twigs) discard;
    float lump = 0.6 * wave(across * 1.1 + 0.8 * place.y + kind + 0.43 * side) + 0.4 * twigs;
    float snowy = white.a * smoothstep(0.30, 0.55, 0.09 + 0.75 * lump - 1.1 * abs(place.y - 0.58));
    vec3 shade = gl_FrontFacing ? vec3(0.55 + 0.7 * place.y * twigs) : vec3(0.35);
    vec3 albedo = gl_FrontFacing ? mix(green * shade, white.rgb, 0.78 * snowy) : green * shade;
    colour = vec4(albedo * light + air, 1.0);
}
