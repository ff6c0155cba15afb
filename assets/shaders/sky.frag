// Sky: above the horizon the sky with thin clouds, below it a valley under haze. At a quarter of the resolution;
// sky_lights.frag puts it where nothing was drawn.
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec2 ndc;
out vec4 colour;

// Share of thin cloud on a plane far above, in streaks that fray. The plane curves down to the horizon, as the sky does.
float cloud(vec3 direction, float steep) {
    vec2 at = direction.xy / (abs(direction.z) + 0.16);
    vec4 veil = textureLod(detail_texture, vec3(at * vec2(0.095, 0.21) + 0.31, DETAIL_SOFT), 1.0);
    vec2 bent = at + 0.35 * (veil.zw - 0.5);
    float streaks = textureLod(detail_texture, vec3(bent * mat2(0.33, 0.15, -0.42, 0.90), DETAIL_SOFT), 1.0).z;
    float shreds = textureLod(detail_texture, vec3(bent * mat2(0.90, 0.50, -1.20, 2.10), DETAIL_SOFT), 1.0).z;
    float thick = 1.5 * veil.w + 0.7 * veil.z + 0.65 * streaks + 0.35 * shreds - 1.62;
    return smoothstep(0.0, 1.0, thick) * min(3.0 * steep, 1.0);
}

void main() {
    vec3 direction = normalize(frame.ray_middle.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz);
    float up = abs(direction.z), toward_lamp = dot(direction, frame.disc.xyz);
    float steep = 1.0 - exp2(-3.6 * up - 9.0 * up * up);
    vec3 low = horizon(direction);
    vec3 far = direction.z > 0.0 ? frame.zenith.rgb : 0.32 * low + 0.35 * frame.zenith.rgb;
    vec3 sky = mix(low, far, steep) + glow(toward_lamp) * (1.0 - 0.6 * steep);
    float veil = cloud(direction, steep);
    bool above = direction.z > 0.0;
    sky = mix(sky, frame.cloud.rgb + glow(toward_lamp), (above ? 0.85 : 0.25) * veil);
    colour = vec4(sky, above ? 1.0 - 0.8 * veil : 0.0);
}
