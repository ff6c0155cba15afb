// A near tree: tiers of branches, each a cone of some sides.
out vec3 light;
out vec3 air;
out vec2 place;       // around, in sides; 0 at the top of a tier to 1 at its rim
flat out vec3 green;
flat out vec4 white;  // snow; share of the branches that it covers
flat out float kind;  // a number of the tier's own

void main() {
    int corner = gl_VertexID % 3, triangle = gl_VertexID / 3;
    int side = triangle % TREE_SIDES, tier = triangle / TREE_SIDES;
    float low = (float(tier) + 0.35) / (float(TREE_TIERS) + 0.35);
    float high = min(low + 2.1 / float(TREE_TIERS), 1.0);
    float own = fract(axis.w * 57.0 + float(tier) * 0.618);
    float turn = (float(side) + (corner == 2 ? 0.5 : float(corner)) + 0.37 * float(tier) + 3.0 * axis.w);
    float angle = turn * 6.2832 / float(TREE_SIDES);
    float radius = look.w * 1.25 * (1.0 - 0.86 * low) * (0.85 + 0.3 * fract(own * 7.0 + 0.29 * float((side + corner) % TREE_SIDES)));

    vec3 first = normalize(abs(axis.z) > 0.7 ? vec3(axis.z, 0.0, -axis.x) : vec3(-axis.y, axis.x, 0.0));
    vec3 second = cross(axis.xyz, first);
    vec3 outward = cos(angle) * first + sin(angle) * second;
    bool top = corner == 2;
    float sag = 0.05 * foot.w * (1.0 - low) * (own - 0.5);
    vec3 at = foot.xyz + axis.xyz * (foot.w * (top ? high : low) + (top ? 0.0 : sag)) + (top ? 0.0 : radius) * outward;
    vec3 normal = normalize(outward + 0.55 * axis.xyz + vec3(0.0, 0.0, 0.25));
    light_branches(normal, at, 0.25 + 0.75 * (top ? high : low), light, air);
    place = vec2(float(side) + (top ? 0.5 : float(corner)), top ? 0.0 : 1.0);
    green = needles();
    white = snow();
    kind = own;
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
