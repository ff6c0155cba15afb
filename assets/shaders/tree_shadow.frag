// The shadow of a tree: what it leaves of the light, as a factor. Its edges are soft, softer toward its tip.
layout(binding = SLOT_TREE_PICTURES) uniform sampler2D pictures;

in vec2 along;
flat in vec3 left;
flat in float strength;
flat in vec3 picture;
out vec4 colour;

// Share of a place that the tree's picture covers, smooth between texels.
float covered() {
    vec2 tile = vec2(TREE_TILE_WIDTH, TREE_TILE_HEIGHT) * exp2(-picture.y);
    vec2 at = tile * vec2(picture.x + 0.5 + 0.5 * along.x * TREE_SHADOW_WIDTH / TREE_SPARE, along.y / TREE_ABOVE) - 0.5;
    ivec2 low = ivec2(floor(at));
    vec2 share = at - floor(at);
    float sum = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec2 near = mix(1.0 - share, share, vec2(corner));
        if (texelFetch(pictures, max(low + corner, 0), int(picture.z)).b > 0.0) sum += near.x * near.y;
    }
    return sum;
}

void main() {
    float aside = abs(along.x) / max(1.0 - along.y, 0.02);
    float dense = (1.0 - smoothstep(0.55 - 0.5 * along.y, 1.0, aside)) * smoothstep(0.0, 0.10, along.y);
    if (picture.z >= 0.0) dense = mix(covered(), dense, 0.15 + 0.85 * along.y);
    colour = vec4(mix(vec3(1.0), left, strength * dense * (0.95 - 0.35 * along.y)), 0.0);  // alpha 0: edges_mark.frag leaves it out
}
