// Powder: opacity of one puff and the light that it gives back, blended over those behind it. Its billows are the
// domes of the detail's clumps and move with it: crisp lobes while it is young, torn and soft when it is old.
layout(binding = SLOT_POWDER_REACH) uniform sampler2D farthest;
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec2 place;
flat in vec4 shown;
flat in vec4 turned;
flat in vec3 to_sun;
flat in vec3 to_glow;
flat in vec4 looks;
flat in float distance_m;
layout(location = 0) out vec4 thick;
layout(location = 1) out vec4 lower;  // share of the lower material, in a cloud of two

void main() {
    float r2 = dot(place, place);
    if (r2 > 1.0) discard;
    mat2 turn = mat2(turned.x, turned.y, -turned.y, turned.x);
    vec4 billow = textureLod(detail_texture, vec3(POWDER_TILE * (turn * place) + turned.zw, DETAIL_CLUMPS), looks.z);
    float dense = smoothstep(0.0, looks.x, 1.3 * (1.0 - r2) - looks.y * (0.62 - billow.z));
    // Where it meets the ground it fades, so that no line shows.
    float reach = texelFetch(farthest, ivec2(gl_FragCoord.xy), 0).r;
    float opacity = shown.x * dense * clamp((reach - distance_m) * shown.w + 0.7, 0.0, 1.0);
    vec2 bump = (billow.xy * 2.0 - 1.0) * turn;
    vec3 normal = normalize(vec3(place * 0.9 - 1.1 * bump, 1.0 - 0.6 * r2));
    // Crevices between lobes are dark, and the side of a lobe toward the sun is bright.
    float crevice = 0.45 + 0.55 * smoothstep(0.25, 0.80, billow.z);
    float sun = shown.y * (0.12 + 0.88 * smoothstep(-0.4, 0.9, dot(normal, to_sun))) * mix(1.0, crevice, 0.7);
    // Looking toward the sun, light comes through the thin rim of a puff.
    float through = max(-to_sun.z, 0.0);
    sun += shown.y * through * through * (0.25 + 0.65 * r2);
    float sky = shown.z * (0.48 + 0.52 * normal.y) * crevice * max(1.0 + 0.9 * dot(normal, to_glow), 0.3);
    thick = vec4(sun, sky, distance_m, 1.0) * opacity;
    lower = vec4(looks.w, 0.0, 0.0, 1.0) * opacity;
}
