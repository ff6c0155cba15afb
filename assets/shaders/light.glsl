// One light for every pass: a warm sun, blue sky light from above, reflected light from below. Linear light.
const vec3 kSun = vec3(1.42, 1.27, 1.05);
const vec3 kSkyLight = vec3(0.15, 0.215, 0.34);
const vec3 kGroundLight = vec3(0.12, 0.11, 0.10);
const vec3 kHorizon = vec3(0.66, 0.79, 0.92);

// Light reflected by a matt surface. `sunlit` and `open` are 0 to 1: sun not hidden, visible share of the
// sky.
vec3 lit(vec3 albedo, vec3 normal, float sunlit, float open) {
    vec3 around = mix(kGroundLight, kSkyLight, 0.5 + 0.5 * normal.z) * open;
    return albedo * (kSun * (max(dot(normal, frame.sun.xyz), 0.0) * sunlit) + around);
}

// The haze near the sun is brighter and warmer.
vec3 glow(vec3 direction) {
    float toward_sun = max(dot(direction, frame.sun.xyz), 0.0);
    toward_sun *= toward_sun;
    return vec3(0.26, 0.20, 0.12) * (toward_sun * toward_sun);
}

// Haze between the eye and a point shows distance.
vec3 through_air(vec3 colour, vec3 at) {
    vec3 path = at - frame.eye.xyz;
    float distance_m = length(path);
    float thickness = max(distance_m - frame.haze.x, 0.0) * frame.haze.y;
    return mix(colour, kHorizon + glow(path / distance_m), thickness / (1.0 + thickness));
}

// Brightness of legend colours in this light: 1 for level ground in the sun, never dark.
float shade(vec3 light) {
    const vec3 kLuminance = vec3(0.21, 0.72, 0.07);
    float full = dot(kSun * frame.sun.z + kSkyLight, kLuminance);
    return 0.5 + 0.5 * min(dot(light, kLuminance) / full, 1.3);
}
