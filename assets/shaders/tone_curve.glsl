// Maps light to screen brightness, both linear, and back. Linear up to a knee, so colours stay true; above it
// highlights fade into white.
const float kKnee = 0.6;

vec3 shown(vec3 light) {
    vec3 t = 1.0 + max(light - kKnee, 0.0) / (4.0 * (1.0 - kKnee));
    t *= t;
    return min(light, kKnee) + (1.0 - kKnee) * (1.0 - 1.0 / (t * t));
}

// Light that is shown as `colour`; white itself would need infinite light.
vec3 light_shown_as(vec3 colour) {
    vec3 above = clamp((colour - kKnee) / (1.0 - kKnee), 0.0, 0.98);
    return min(colour, kKnee) + 4.0 * (1.0 - kKnee) * (inversesqrt(sqrt(1.0 - above)) - 1.0);
}

vec3 from_srgb(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}
