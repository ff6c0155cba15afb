// The shadow of a tree: what it leaves of the light, as a factor. Its edges are soft, softer toward its tip.
in vec2 along;
flat in vec3 left;
flat in float strength;
flat in vec4 picture;
out vec4 colour;

// Share of a place that the tree's picture covers.
float covered() {
    vec2 tile = vec2(TREE_TILE_WIDTH, TREE_TILE_HEIGHT) * exp2(-picture.y);
    return covered_at(tile * vec2(picture.x + 0.5 + 0.5 * along.x * TREE_SHADOW_WIDTH / TREE_SPARE, along.y / TREE_ABOVE), int(picture.z)).a;
}

void main() {
    float aside = abs(along.x) / max(1.0 - along.y, 0.02);
    float dense = (1.0 - smoothstep(0.55 - 0.5 * along.y, 1.0, aside)) * smoothstep(0.0, 0.10, along.y);
    if (picture.w > 0.0) dense = 1.0 - smoothstep(0.45, 1.0, length(vec2(along.x, (along.y - 0.55) / 0.48)));
    if (picture.z >= 0.0 && along.y < 1.0) dense = mix(covered(), dense, 0.15 + 0.85 * along.y);
    colour = vec4(mix(vec3(1.0), left, strength * dense * max(0.95 - 0.35 * along.y, 0.0)), 0.0);  // alpha 0: edges_mark.frag leaves it out
}
