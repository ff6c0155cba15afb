// Trees' pictures between their texels.
layout(binding = SLOT_TREE_PICTURES) uniform sampler2D pictures;  // render/textures/tree_pictures.h

// At a place of a level, texels: what the covered ones of the nearest four show, by nearness, and how much they cover, 0 to 1.
// Uncovered ones have no colour.
vec4 covered_at(vec2 at, int level) {
    ivec2 low = ivec2(floor(at - 0.5));
    vec2 share = at - 0.5 - floor(at - 0.5);
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec2 near = mix(1.0 - share, share, vec2(corner));
        vec3 texel = texelFetch(pictures, max(low + corner, 0), level).rgb;
        if (texel.b > 0.0) sum += near.x * near.y * vec4(texel, 1.0);
    }
    return sum;
}
