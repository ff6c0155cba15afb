// Powder, its light: what a coarse pixel's cloud looks like in this light, and the shadow that it casts on the
// ground behind.
layout(binding = SLOT_POWDER_REACH) uniform sampler2D farthest;
layout(binding = SLOT_POWDER_THICK) uniform sampler2D thick;
layout(binding = SLOT_POWDER_LOWER) uniform sampler2D lower;
layout(binding = SLOT_POWDER_SHADE) uniform sampler2D shade_map;

in vec2 ndc;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 hidden;  // the cloud is seen by x − y · depth of the scene, cut to 0 to 1; shadow on the ground

// Share of the light that the cloud takes from a place on the ground. Far below the cloud its shadow has become faint.
float shaded(vec3 at) {
    vec2 cell = vec2(dot(powder.across.xyz, at) + powder.across.w, dot(powder.up.xyz, at) + powder.up.w);
    vec2 inside = clamp((0.5 - abs(cell - 0.5)) * 20.0, 0.0, 1.0);
    vec2 made = texture(shade_map, cell).rg;
    float below = (made.y / max(made.x, 1e-4) - dot(frame.sun.xyz, at)) / powder.colour.w;  // mean radii, from the cloud on
    return (1.0 - exp2(-1.44 * made.x)) * inside.x * inside.y * clamp(below + 0.5, 0.0, 1.0) * smoothstep(POWDER_SHADOW, 0.5 * POWDER_SHADOW, below);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 cloud = texelFetch(thick, pixel, 0);
    float reach = texelFetch(farthest, pixel, 0).r, whole = max(cloud.a, 1e-4);
    vec2 light = cloud.xy / whole;
    vec3 at = place_at(ndc, cloud.a > 0.0 ? cloud.z / whole : reach);

    // Light passes from grain to grain, so that even the depth of the cloud is bright. What comes from the snow all around
    // takes colour from a low sun: without that, thin powder before a dark wood looks like smoke.
    vec3 lamp = mix(frame.lamp.rgb, vec3(dot(frame.lamp.rgb, vec3(0.21, 0.72, 0.07))), 0.5);
    vec3 sky = mix(frame.below.rgb, frame.above.rgb, 0.80 + 0.20 * light.y);
    vec3 grains = mix(powder.colour.rgb, powder.lower_colour.rgb, powder.lower_colour.w * texelFetch(lower, pixel, 0).r / whole);
    vec3 lit = grains * (lamp * (1.25 * light.x) + sky * (0.45 + 1.05 * light.y));
    // Grains pass most light on forward: toward the sun a cloud glows where it is thin, at its edges.
    float toward = max(dot(normalize(at - frame.eye.xyz), frame.sun.xyz), 0.0), toward_4 = toward * toward * toward * toward;
    float thin = 1.15 - cloud.a;
    lit += grains * lamp * ((0.9 * toward_4 + 3.0 * toward_4 * toward_4 * toward_4) * light.x * thin);
    // And what many grains have passed on is white: a cloud against the sun is never brown.
    lit += grains * (0.14 * (1.0 + toward) * dot(lamp, vec3(0.333)));
    lit = through_air(lit, at);

    vec3 ground = place_at(ndc, reach);
    float dark = reach < 50000.0 ? shaded(ground) * sunlit(ground) * (1.0 - cloud.a) : 0.0;
    colour = vec4(lit * cloud.a, cloud.a + powder.shadow.a * dark);
    float distance_m = (cloud.z + reach * dark) / max(cloud.a + dark, 1e-4), soft = 2.0 * powder.colour.w;
    float from = frame.ray_forward.w / max(distance_m - 1.6 * soft, frame.ray_forward.w),
          to = frame.ray_forward.w / max(distance_m - 0.6 * soft, 2.0 * frame.ray_forward.w);
    hidden = vec4(vec2(from, 1.0) / (from - to), dark, 0.0);
}
