// Trees: what their vertex shaders share. A vertex finds its tree by its number, in tree_buffer.glsl.
struct Tree {
    vec4 foot;    // m; height, m
    vec4 axis;    // unit vector from foot to top; the tree's own number, 0 to 1
    vec4 look;    // sunlit 0 to 1; 0; share of the lower material there; half its width, m
    vec4 shadow;  // m, where the shadow of its top meets the ground; strength of the shadow, 0 to 1
    vec4 kind;    // TREE_*; number of tops, more than one: a group; how closed the wood is around it, 0 to 1; share of the snow that its branches keep, 0 where none fell
};

// A number of the tree's own, 0 to 1, for each factor another.
float own(Tree tree, float factor) { return fract(tree.axis.w * factor); }

bool is_kind(Tree tree, int kind) { return tree.kind.x == float(kind); }
bool is_broad(Tree tree) { return tree.kind.x > float(TREE_PINE); }
// Whether leaves, or needles of a larch, are on it: birches lose them first, larches last. None have any where no date is stated.
bool in_leaf(Tree tree) {
    if (!is_broad(tree) && !is_kind(tree, TREE_LARCH)) return false;
    float first = is_kind(tree, TREE_BIRCH) ? 0.35 : is_kind(tree, TREE_LARCH) ? 0.02 : 0.12;
    return frame.season.y > first + 0.55 * own(tree, 43.1);
}
// Colours of leaves: of summer, of the first days of turning, and turned. Some trees turn weeks before others, so that a wood in
// autumn is a patchwork.
vec3 leaves(Tree tree) {
    float tint = own(tree, 13.7), other = own(tree, 33.9), late = own(tree, 43.1);
    vec3 green = mix(vec3(0.030, 0.068, 0.016), vec3(0.066, 0.098, 0.022), tint), yellow = vec3(0.190, 0.150, 0.030);
    vec3 turned = mix(vec3(0.270, 0.140, 0.030), vec3(0.160, 0.062, 0.020), other);  // beech: amber to copper
    float first = 0.28 + 0.75 * late;
    if (is_kind(tree, TREE_BIRCH)) {
        green = mix(vec3(0.066, 0.112, 0.028), vec3(0.086, 0.126, 0.034), tint);
        turned = mix(vec3(0.330, 0.225, 0.035), vec3(0.300, 0.175, 0.028), other);
        first = 0.05 + 0.65 * late;
    }
    if (is_kind(tree, TREE_LARCH)) {
        green = mix(vec3(0.052, 0.086, 0.030), vec3(0.072, 0.096, 0.030), tint);
        turned = mix(vec3(0.320, 0.200, 0.036), vec3(0.270, 0.140, 0.026), other);
        first = 0.40 + 0.50 * late;
    }
    if (is_kind(tree, TREE_BUSH)) {
        green = mix(vec3(0.040, 0.074, 0.026), vec3(0.066, 0.086, 0.034), tint);
        turned = mix(vec3(0.230, 0.165, 0.040), vec3(0.180, 0.066, 0.030), other * other);
        first = 0.20 + 0.85 * late;
    }
    // Leaves of spring are lighter.
    if (frame.season.z == 0.0) green *= 1.0 + 0.35 * (1.0 - smoothstep(0.6, 1.0, frame.season.y)) * vec3(1.2, 1.0, 0.6);
    float gone = clamp((frame.season.z + 0.5 * frame.season.z * (1.0 - frame.season.y) - first) / 0.35, 0.0, 1.0);
    return mix(mix(green, yellow, min(2.0 * gone, 1.0)), 0.9 * turned, max(2.0 * gone - 1.0, 0.0));
}
vec3 bark(Tree tree) {
    if (is_kind(tree, TREE_BIRCH)) return in_leaf(tree) ? vec3(0.210, 0.200, 0.180) : vec3(0.105, 0.086, 0.076);  // with all its twigs
    if (is_kind(tree, TREE_BUSH)) return vec3(0.062, 0.048, 0.036);
    return mix(vec3(0.068, 0.060, 0.051), vec3(0.050, 0.041, 0.033), own(tree, 13.7));
}
// Colours of needles: blue-green to yellow-green, brown where the tree lies; and lighter or darker. Of broad-leaved trees, of leaves;
// where there are none, of bark.
vec3 needles(Tree tree) {
    float tint = own(tree, 13.7);
    vec3 green = mix(vec3(0.018, 0.035, 0.027), vec3(0.046, 0.052, 0.024), tint * tint);
    if (tree.kind.x == float(TREE_LARCH)) green = mix(vec3(0.150, 0.112, 0.078), vec3(0.105, 0.085, 0.068), tint);
    if (tree.kind.x == float(TREE_PINE)) green = mix(vec3(0.028, 0.044, 0.022), vec3(0.040, 0.050, 0.024), tint);
    if (is_broad(tree)) green = bark(tree);
    if (in_leaf(tree)) green = leaves(tree);
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
    bool leafy = in_leaf(tree);
    if (is_broad(tree)) {
        if (group) return float(leafy ? TREE_COLUMN_LEAVES : TREE_COLUMN_BARE_GROUP);
        if (!leafy) return float(TREE_COLUMN_BARE);
        if (is_kind(tree, TREE_BIRCH)) return float(TREE_COLUMN_BIRCH);
        if (is_kind(tree, TREE_BUSH)) return float(TREE_COLUMN_BUSH);
        return float(TREE_COLUMN_BEECH) + step(0.5, own(tree, 57.0));
    }
    if (group) return float(TREE_COLUMN_GROUP);
    if (leafy) return float(TREE_COLUMN_GREEN_LARCH);
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
    vec3 lamp = frame.lamp.rgb * (tree.look.x * through_clouds(tree.foot.xy)), sky = frame.above.rgb;
    float sunward = dot(front.xy, vec2(frame.toward.w, frame.away.w));
    vec3 aside = 0.5 * (frame.below.rgb + sky) * (1.0 + 0.7 * frame.zenith.w * sunward);
    float toward = cosine * dot(frame.sun.xyz, front), along = dot(frame.sun.xyz, tree.axis.xyz);
    float through = max(-dot(frame.sun.xyz, view), 0.0);  // against the sun light comes through twigs and snow
    through *= through;
    float needle = max((0.90 * toward + 0.35 * along + 0.20) / 1.2, 0.03) + (in_leaf(tree) ? 0.75 : 0.30) * through;
    float snow = max((0.45 * toward + 0.80 * along + 0.10) / 1.1, 0.02) + 0.18 * through;
    return Lights(lamp * needle + mix(aside, sky, 0.35), lamp * snow + mix(aside, sky, 0.75));
}
