// Powder: thickness of one puff and the light that it gives back, blended over those behind it. Its billows are
// those of the detail's clumps and move with it.
layout(binding = SLOT_POWDER_REACH) uniform sampler2D farthest;
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec2 place;
flat in vec4 shown;
flat in vec4 turned;
flat in vec3 to_sun;
flat in float distance_m;
out vec4 thick;

void main() {
    float r2 = dot(place, place);
    if (r2 > 1.0) discard;
    mat2 turn = mat2(turned.x, turned.y, -turned.y, turned.x);
    vec4 billow = textureLod(detail_texture, vec3(turn * place + turned.zw, DETAIL_CLUMPS), 2.0);
    float dense = smoothstep(0.0, 0.8, 1.25 * (1.0 - r2) - 2.2 * (0.62 - billow.z));
    // Where it meets the ground it fades, so that no line shows.
    float reach = texelFetch(farthest, ivec2(gl_FragCoord.xy), 0).r;
    float opacity = shown.x * dense * clamp((reach - distance_m) * shown.w + 0.7, 0.0, 1.0);
    vec2 bump = (billow.xy * 2.0 - 1.0) * turn * 13.3;
    vec3 normal = normalize(vec3(place * 0.9 - bump, 1.0 - 0.6 * r2));
    float sun = shown.y * (0.3 + 0.7 * smoothstep(-0.5, 1.0, dot(normal, to_sun)));
    float sky = shown.z * (0.55 + 0.45 * normal.y);
    thick = vec4(sun, sky, distance_m, 1.0) * opacity;
}
