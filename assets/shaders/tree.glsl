// Conifers: what their vertex shaders share. A vertex finds its tree by its number, in tree_buffer.glsl.
struct Tree {
    vec4 foot;    // m; height, m
    vec4 axis;    // unit vector from foot to top; the tree's own number, 0 to 1
    vec4 look;    // sunlit 0 to 1; snow around it, m; share of the lower material there; half its width, m
    vec4 shadow;  // m, where the shadow of its top meets the ground; strength of the shadow, 0 to 1
    vec4 kind;    // TREE_*; number of tops, more than one: a group; how closed the wood is around it, 0 to 1; 0
};

// Colours of needles, and of snow on the branches if snow lies around the tree.
vec3 needles(Tree tree) {
    float own = fract(tree.axis.w * 13.7);
    vec3 green = mix(vec3(0.011, 0.024, 0.020), vec3(0.024, 0.034, 0.018), own);  // blue-green to green
    if (tree.kind.x == float(TREE_LARCH)) green = mix(vec3(0.120, 0.096, 0.070), vec3(0.090, 0.075, 0.060), own);
    if (tree.kind.x == float(TREE_PINE)) green = mix(vec3(0.020, 0.031, 0.015), vec3(0.027, 0.034, 0.017), own);
    return mix(vec3(0.050, 0.042, 0.024), green, clamp(2.0 * tree.axis.z, 0.0, 1.0));  // brown where it lies
}
// Some carry much of it, others have shed it.
vec4 snow(Tree tree) {
    vec3 lies = mix(frame.standing.rgb, frame.lower_standing.rgb, tree.look.z);
    float carried = mix(0.35, 1.0, fract(tree.axis.w * 29.3)) * (tree.kind.x == float(TREE_LARCH) ? 0.45 : 1.0);
    return vec4(lies, carried * smoothstep(0.02, 0.30, tree.look.y) * smoothstep(0.55, 0.75, lies.g));
}

// Light that white branches reflect toward the eye, and the air before them. `up`: 0 at the foot, 1 at the top.
// Within a stand its trees shade each other's feet.
void light_branches(Tree tree, vec3 normal, vec3 at, float up, out vec3 light, out vec3 air) {
    air = through_air(vec3(0.0), at);
    vec3 kept = through_air(vec3(1.0), at) - air;
    float shaded = mix(0.45, 0.80, tree.kind.z) * (1.0 - up) * (1.0 - up);
    light = kept * lit(vec3(1.0), normal, tree.look.x * (1.0 - shaded), 1.0 - shaded);
}

// A corner of a triangle around the axis that is turned to the eye and lit as if it were a cone. `place`: −1 to 1 across,
// 0 at the foot to 1 at the top; `curved`: 0 to 1, how much its sides look aside.
void around_axis(Tree tree, vec2 place, float half_width, float curved, out vec3 at, out vec3 light, out vec3 air) {
    vec3 to_eye = frame.eye.xyz - tree.foot.xyz;
    vec3 across = cross(tree.axis.xyz, to_eye);
    across *= inversesqrt(max(dot(across, across), 1e-6));
    vec3 front = cross(across, tree.axis.xyz);
    at = tree.foot.xyz + tree.foot.w * place.y * tree.axis.xyz + half_width * place.x * across;
    vec3 normal = normalize((curved * place.x) * across + 0.45 * front + 0.35 * tree.axis.xyz + vec3(0.0, 0.0, 0.2));
    light_branches(tree, normal, at, min(place.y, 1.0), light, air);
}
