// One light for every pass: sun or moon, light from the sky above and from the ground below, and the air between.
// Its colours come from render/view/sky_light.h. Linear light.

// Light reflected by a matt surface. `sunlit` and `open` are 0 to 1: sun not hidden, visible share of the
// sky.
vec3 lit(vec3 albedo, vec3 normal, float sunlit, float open) {
    // The sky is brighter on one side and has the colours of its horizon, which gives shape to slopes in the shade.
    float sunward = dot(normal.xy, vec2(frame.toward.w, frame.away.w)), glowing = 0.75 * max(frame.zenith.w, 0.0);
    // What faces away from the glow keeps some of it, or snow in the shade would be cyan.
    glowing *= sunward > 0.0 ? 1.0 : 0.3;
    vec3 sky = frame.above.rgb * (1.0 + frame.zenith.w * sunward) +
               (glowing * sunward) * (frame.toward.rgb - frame.away.rgb);
    // Under a high sun even slopes look flat. They are drawn with more contrast then, as a photographer prints them,
    // by their difference from level ground; and hollows darker and bluer, as snow is there: they lose sun, not sky.
    const float kContrast = 0.75;
    float facing = max(dot(normal, frame.sun.xyz), 0.0);
    facing *= 1.0 + kContrast * frame.lamp.w * (facing - frame.sun.z);
    sunlit *= mix(1.0, min(open + 0.1, 1.0), 0.9 * frame.lamp.w);
    vec3 around = mix(frame.below.rgb, sky, 0.5 + 0.5 * normal.z) * mix(open, 1.0, 0.5 * frame.lamp.w);
    return albedo * (frame.lamp.rgb * (facing * sunlit) + around);
}

float of_corner(ivec2 corner) {
    uint h = (uint(corner.x) * 0x9E3779B1u) ^ (uint(corner.y) * 0x85EBCA77u);
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    return float((h ^ (h >> 13)) & 0xFFFFu) / 65535.0;
}
float noise_at(vec2 at) {
    ivec2 low = ivec2(floor(at));
    vec2 share = at - floor(at);
    share *= share * (3.0 - 2.0 * share);
    return mix(mix(of_corner(low), of_corner(low + ivec2(1, 0)), share.x),
               mix(of_corner(low + ivec2(0, 1)), of_corner(low + ivec2(1, 1)), share.x), share.y);
}
// What fair-weather clouds let through of the sun at a place, on a day with plants.
float through_clouds(vec2 at) {
    if (frame.season.w == 0.0) return 1.0;
    float thick = 0.62 * noise_at(at / 540.0 + 31.7) + 0.26 * noise_at(at / 210.0 + 7.1) + 0.12 * noise_at(at / 85.0 - 3.3);
    return 1.0 - 0.50 * smoothstep(0.54, 0.67, thick);
}

// What a shadow on the ground leaves of the light, where it is darkest: that of the sky.
vec3 left_by_shadow() {
    vec3 sky = frame.above.rgb, sun = frame.lamp.rgb * max(frame.sun.z, 0.15);
    return sky / (sky + sun);
}

// The sky at the horizon in a direction: warm toward a low sun, bluer opposite.
vec3 horizon(vec3 direction) {
    float toward_sun = 0.5 + 0.5 * dot(direction.xy, vec2(frame.toward.w, frame.away.w));
    return mix(frame.away.rgb, frame.toward.rgb, toward_sun * toward_sun);
}

// The air near the lamp is brighter. `toward_lamp`: cosine of the angle to it.
vec3 glow(float toward_lamp) {
    float t = max(toward_lamp, 0.0), t4 = t * t * t * t, t16 = t4 * t4 * t4 * t4;
    float t64 = t16 * t16 * t16 * t16, t256 = t64 * t64 * t64 * t64;
    return frame.glow.rgb * (0.12 * t4 + 0.30 * t16 + 0.45 * t256);
}

// Haze between the eye and a point shows distance: twice as thick in the valley as high above it. It takes blue
// light first.
vec3 through_air(vec3 colour, vec3 at) {
    vec3 path = at - frame.eye.xyz;
    float distance_m = length(path);
    vec3 direction = path / distance_m;
    float height = max(mix(at.z, frame.eye.z, 0.25) - frame.haze.y, 0.0);  // of the middle of the haze
    float thickness = distance_m * frame.haze.x * (1.0 + exp2(height / -140.0));
    vec3 kept = exp2(-1.44 * thickness * vec3(0.80, 1.0, 1.30));
    return mix(frame.below.w * horizon(direction) + glow(dot(direction, frame.disc.xyz)), colour, kept);
}

// Brightness of legend colours in this light: 1 for level ground in the sun, never dark.
float shade(vec3 light) {
    const vec3 kLuminance = vec3(0.21, 0.72, 0.07);
    float full = dot(frame.lamp.rgb * frame.sun.z + frame.above.rgb, kLuminance);
    return 0.5 + 0.5 * min(dot(light, kLuminance) / full, 1.3);
}
