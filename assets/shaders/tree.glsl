// Conifers: what their vertex shaders share. A vertex finds its tree by its number, in tree_buffer.glsl.
struct Tree {
    vec4 foot;    // m; height, m
    vec4 axis;    // unit vector from foot to top; the tree's own number, 0 to 1
    vec4 look;    // sunlit 0 to 1; 0; share of the lower material there; half its width, m
    vec4 shadow;  // m, where the shadow of its top meets the ground; strength of the shadow, 0 to 1
    vec4 kind;    // TREE_*; number of tops, more than one: a group; how closed the wood is around it, 0 to 1; share of the snow that its branches keep, 0 where none fell
};

// A number of the tree's own, 0 to 1, for each factor another.
float own(Tree tree, float factor) { return fract(tree.axis.w * factor); }

// Colours of needles: blue-green to yellow-green, brown where the tree lies; and lighter or darker.
vec3 needles(Tree tree) {
    float tint = own(tree, 13.7);
    vec3 green = mix(vec3(0.018, 0.035, 0.027), vec3(0.046, 0.052, 0.024), tint * tint);
    if (tree.kind.x == float(TREE_LARCH)) green = mix(vec3(0.150, 0.112, 0.078), vec3(0.105, 0.085, 0.068), tint);
    if (tree.kind.x == float(TREE_PINE)) green = mix(vec3(0.028, 0.044, 0.022), vec3(0.040, 0.050, 0.024), tint);
    green = mix(vec3(0.060, 0.048, 0.028), green, clamp(2.0 * tree.axis.z, 0.0, 1.0));
    return green * mix(0.80, 1.20, own(tree, 71.3));
}
// Some carry much snow, others have shed it: share of the most, 0 to 1.
float carried(Tree tree) { return max(tree.kind.w, min(frame.meadow.w, 0.8)) * own(tree, 29.3); }
// Its colour, and how much of what branches carry is there: it came with the snow near the tree, or with old snow.
vec4 snow(Tree tree) {
    vec3 lies = mix(frame.standing.rgb, frame.lower_standing.rgb, tree.look.z);
    float there = max(smoothstep(0.0, 0.3, tree.kind.w), smoothstep(0.02, 0.30, frame.meadow.w)) * smoothstep(0.55, 0.75, lies.g);
    return vec4(lies, there * (tree.kind.y > 1.5 ? mix(0.5, 1.1, carried(tree)) : 1.0));  // a group has one picture
}

// Of all trees, the column of its pictures.
float column_of(Tree tree, bool group) {
    if (group) return float(TREE_COLUMN_GROUP);
    if (tree.kind.x == float(TREE_PINE)) return float(TREE_COLUMN_PINE);
    if (tree.kind.x == float(TREE_LARCH)) return float(TREE_COLUMN_LARCH);
    if (own(tree, 57.0) < TREE_BROKEN && tree.axis.z > 0.9) return float(TREE_COLUMN_BROKEN);
    return min(floor(float(TREE_SPRUCES) * carried(tree)), float(TREE_SPRUCES) - 1.0);
}

// Light that falls on needles, which face the eye, and on snow on branches, which faces up. `front`: unit vector across the
// axis to the eye; `view`: to the eye; `cosine`: of the eye's height above the tree.
struct Lights {
    vec3 needle, snow;
};
Lights lights_of(Tree tree, vec3 front, vec3 view, float cosine) {
    vec3 lamp = frame.lamp.rgb * tree.look.x, sky = frame.above.rgb;
    float sunward = dot(front.xy, vec2(frame.toward.w, frame.away.w));
    vec3 aside = 0.5 * (frame.below.rgb + sky) * (1.0 + 0.7 * frame.zenith.w * sunward);
    float toward = cosine * dot(frame.sun.xyz, front), along = dot(frame.sun.xyz, tree.axis.xyz);
    float through = max(-dot(frame.sun.xyz, view), 0.0);  // against the sun light comes through twigs and snow
    through *= through;
    float needle = max((0.90 * toward + 0.35 * along + 0.20) / 1.2, 0.03) + 0.30 * through;
    float snow = max((0.45 * toward + 0.80 * along + 0.10) / 1.1, 0.02) + 0.18 * through;
    return Lights(lamp * needle + mix(aside, sky, 0.35), lamp * snow + mix(aside, sky, 0.75));
}
