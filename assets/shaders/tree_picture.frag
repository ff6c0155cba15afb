// A tree, or a group of some: its picture, lit.
in vec4 place;
flat in vec4 dark;
flat in vec4 white;
flat in vec4 air;
flat in float hues;
out vec4 colour;

// Near the eye texels would show as squares: what is between four of them, and ragged, as needles are.
vec3 enlarged(vec2 at) {
    uvec2 cell = uvec2(ivec2(floor(4.0 * at)));
    uint own = (cell.x * 0x9E3779B1u) ^ (cell.y * 0x85EBCA77u);
    own = (own ^ (own >> 15)) * 0x2C1B3C6Du;
    own ^= own >> 13;
    at += (vec2(float(own & 0xFFFFu), float(own >> 16)) / 65535.0 - 0.5) * vec2(0.9, 0.6);
    vec4 seen = covered_at(at, 0);
    return seen.a < 0.5 ? vec3(0.0) : seen.rgb / seen.a;
}

// Leaves and needles at the outside of a crown are yellower than those in its shade, and sprays of them differ.
vec3 in_crown(vec3 needles, float bright, vec2 at) {
    float spray = 0.5 + 0.25 * sin(dot(at, vec2(9.0, 13.0))) + 0.25 * sin(dot(at, vec2(-15.0, 7.0)) + 2.0);
    float outside = clamp(1.7 * bright - 0.55 + 0.35 * (spray - 0.5), 0.0, 1.0);
    return needles * mix(vec3(1.0), mix(vec3(0.66, 0.80, 0.98), vec3(1.30, 1.16, 0.80), outside), hues);
}

void main() {
    vec3 tree = air.w < 0.0 ? enlarged(place.zw) : texelFetch(pictures, ivec2(place.zw), int(air.w)).rgb;
    if (tree.b == 0.0 || abs(place.x) > 1.0 || place.y > 1.0) discard;  // the triangle is larger than the picture
    float foot = 1.0 - place.y;
    float left = tree.b * (1.0 - white.w * foot * foot) * (1.0 + dark.w * (2.0 * tree.r - 1.0));
    vec3 needles = kDated ? in_crown(dark.rgb, tree.b, place.xy) : dark.rgb;
    colour = vec4((needles + white.rgb * tree.g) * left + air.rgb, 0.0);  // alpha 0: edges_mark.frag leaves it out
}
