// Spindrift: streaks of snow in the wind, densest at the ridge, torn at the end. It hides behind ground, softly.
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec2 place;
in vec2 fine, coarse;
in float distance_m;
flat in vec4 colour;
flat in vec2 level;
out vec4 seen;

void main() {
    float streak = 0.6 * textureLod(detail_texture, vec3(fine, DETAIL_SOFT), level.x).z + 0.9 * textureLod(detail_texture, vec3(coarse, DETAIL_SOFT), level.y).z;
    float rest = 1.0 - place.x;
    float body = (1.0 - place.y * place.y) * min(place.x * 5.0, 1.0) * rest;
    float dense = smoothstep(0.0, 0.9, body * 1.4 + (streak - 0.85) * (0.7 + 0.9 * place.x)) * rest;
    float scene = frame.ray_forward.w / max(scene_depth_at(ivec2(gl_FragCoord.xy)), 1e-9);
    float alpha = colour.a * dense * clamp((scene - distance_m) / 5.0 + 0.8, 0.0, 1.0);
    seen = vec4(colour.rgb * alpha, alpha);
}
