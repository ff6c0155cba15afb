// A tree, or a group of some: its picture, lit.
layout(binding = SLOT_TREE_PICTURES) uniform sampler2D pictures;  // render/textures/conifer_pictures.h

in vec4 place;
flat in vec4 dark;
flat in vec4 white;
flat in vec4 air;
out vec4 colour;

// Near the eye texels would show as squares: what is between four of them, and ragged, as needles are. Uncovered ones have
// no colour.
vec3 enlarged(vec2 at) {
    uvec2 cell = uvec2(ivec2(floor(4.0 * at)));
    uint own = (cell.x * 0x9E3779B1u) ^ (cell.y * 0x85EBCA77u);
    own = (own ^ (own >> 15)) * 0x2C1B3C6Du;
    own ^= own >> 13;
    at += (vec2(float(own & 0xFFFFu), float(own >> 16)) / 65535.0 - 0.5) * vec2(0.9, 0.6) - 0.5;
    ivec2 low = ivec2(floor(at));
    vec2 share = at - floor(at);
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec2 near = mix(1.0 - share, share, vec2(corner));
        vec3 texel = texelFetch(pictures, low + corner, 0).rgb;
        if (texel.b > 0.0) sum += near.x * near.y * vec4(texel, 1.0);
    }
    return sum.a < 0.5 ? vec3(0.0) : sum.rgb / sum.a;
}

void main() {
    vec3 tree = air.w < 0.0 ? enlarged(place.zw) : texelFetch(pictures, ivec2(place.zw), int(air.w)).rgb;
    if (tree.b == 0.0 || abs(place.x) > 1.0 || place.y > 1.0) discard;  // the triangle is larger than the picture
    float foot = 1.0 - place.y;
    float left = tree.b * (1.0 - white.w * foot * foot) * (1.0 + dark.w * (2.0 * tree.r - 1.0));
    colour = vec4((dark.rgb + white.rgb * tree.g) * left + air.rgb, 0.0);  // alpha 0: edges_mark.frag leaves it out
}
