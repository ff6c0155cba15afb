// A near tree: a trunk, and tiers of branches, each a cone of some sides.
out vec3 light;
out vec3 air;
out vec2 place;       // around, in sides; 0 at the top of a tier to 1 at its rim
flat out vec3 green;
flat out vec4 white;  // snow; share of the branches that it covers
flat out vec2 kind;   // a number of the tier's own; share of the branches that have needles, below 0: a trunk

void main() {
    Tree tree = tree_at(gl_VertexID / TREE_VERTICES);
    int vertex = gl_VertexID % TREE_VERTICES;
    int corner = vertex % 3, triangle = vertex / 3;
    int side = triangle % TREE_SIDES, tier = triangle / TREE_SIDES;
    bool trunk = tier == TREE_TIERS, top = corner == 2;
    float low = trunk ? 0.0 : (float(tier) + 0.45) / (float(TREE_TIERS) + 0.45);
    float high = trunk ? 0.9 : min(low + 1.75 / float(TREE_TIERS), 1.0);
    float own = fract(tree.axis.w * 57.0 + float(tier) * 0.618);
    float sides = trunk ? 3.0 : float(TREE_SIDES);
    float turn = float(side) + (top ? 0.5 : float(corner)) + 0.37 * float(tier) + 3.0 * tree.axis.w;
    float angle = turn * 6.2832 / sides;
    float radius = tree.look.w * 1.25 * (1.0 - 0.88 * low) * (0.80 + 0.4 * fract(own * 7.0 + 0.29 * float((side + corner) % TREE_SIDES)));
    if (trunk) radius = 0.016 * tree.foot.w;

    vec3 first = normalize(abs(tree.axis.z) > 0.7 ? vec3(tree.axis.z, 0.0, -tree.axis.x) : vec3(-tree.axis.y, tree.axis.x, 0.0));
    vec3 second = cross(tree.axis.xyz, first);
    vec3 outward = cos(angle) * first + sin(angle) * second;
    float sag = trunk ? 0.0 : 0.05 * tree.foot.w * (1.0 - low) * (own - 0.5);
    vec3 at = tree.foot.xyz + tree.axis.xyz * (tree.foot.w * (top ? high : low) + (top ? 0.0 : sag)) + (top ? 0.0 : radius) * outward;
    vec3 normal = normalize(outward + 0.55 * tree.axis.xyz + vec3(0.0, 0.0, 0.25));
    light_branches(tree, normal, at, 0.15 + 0.85 * (top ? high : low), light, air);
    place = vec2(float(side) + (top ? 0.5 : float(corner)), top ? 0.0 : 1.0);
    green = trunk ? vec3(0.040, 0.029, 0.021) : needles(tree);
    white = snow(tree);
    kind = vec2(own, trunk ? -1.0 : tree.kind.x == float(TREE_LARCH) ? 0.22 : 1.0);
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
