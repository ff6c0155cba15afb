// A tree, or a group of some, as a picture that is turned to the eye: one triangle around it. Of its pictures the one is
// chosen that was drawn from the height nearest to the eye's.
out vec4 place;       // −1 to 1 across the picture, 0 to 1 up; texels of the level
flat out vec4 dark;   // light from needles to the eye; how much brighter they are on one side
flat out vec4 white;  // how much more comes from snow on them; share of the light that is lost at the foot
flat out float hues;  // how much they differ within a crown, 0 to 1
flat out vec4 air;    // light of the air before it; level of the pictures, −1: the finest, and its texels are larger than samples

// A corner of a triangle around a cone of this base, or around what is round: across and up, in heights of the tree.
vec2 corner_around(int corner, bool is_round, float radius, float low, float sine, float cosine) {
    float deep = radius * sine, tall = 1.10 * cosine + 0.03 + 0.7 * deep;
    if (is_round) {
        deep = TREE_ABOVE * cosine + 0.5 * radius * sine;
        tall = 1.7 * deep;
    }
    if (corner == 2) return vec2(0.0, tall);
    float slope = radius * inversesqrt(max(tall * tall - deep * deep, 1e-3));
    return vec2((corner == 0 ? -1.0 : 1.0) * slope * (tall - low), low);
}

// The same around a broad-leaved tree: an ellipse, the crown, above its stem. `lowest`: lower edge of the picture.
vec2 corner_around_crown(int corner, float radius, float lowest, float sine, float cosine) {
    float middle = 0.57 * cosine, deep = length(vec2(0.45 * cosine, radius * sine));
    float low = max(min(middle - deep, -0.02), lowest), tall = middle + 1.9 * deep;
    return corner == 2 ? vec2(0.0, tall) : vec2((corner == 0 ? -0.62 : 0.62) * radius / deep * (tall - low), low);
}

void main() {
    Tree tree = tree_at(gl_VertexID / 3);
    float high = tree.foot.w, radius = tree.look.w / high;
    bool group = tree.kind.y > 1.5, pine = tree.kind.x == float(TREE_PINE);
    vec3 axis = tree.axis.xyz, middle = tree.foot.xyz + 0.5 * high * axis, to_eye = frame.eye.xyz - middle;
    float away = length(to_eye);
    vec3 view = to_eye / away, across = cross(axis, view);
    across *= inversesqrt(max(dot(across, across), 1e-6));
    vec3 front = cross(across, axis), up = cross(view, across);
    float above = dot(axis, view), sine = clamp(above, 0.0, 0.98), cosine = sqrt(max(1.0 - above * above, 0.04));

    float wide = TREE_SPARE * radius, low = -wide * sine, top = TREE_ABOVE * cosine + wide * sine * sine;
    vec2 card = corner_around(gl_VertexID % 3, group || pine, 1.02 * radius, low, sine, cosine);
    if (is_broad(tree) && !group) card = corner_around_crown(gl_VertexID % 3, 1.02 * radius, low, sine, cosine);
    vec3 at = middle + high * (card.x * across + (card.y - 0.5 * cosine) * up);
    at += min(0.8 * tree.look.w / away, 0.5) * (frame.eye.xyz - at);  // before the ground, which would cut its branches off
    gl_Position = frame.clip_from_world * vec4(at, 1.0);

    float mirror = own(tree, 91.0) < 0.5 ? -1.0 : 1.0;
    float seen_from = sine + 0.10 * (own(tree, 17.0) - 0.5);  // a wood does not change its pictures all at once
    float row = dot(vec3(1.0), step(vec3(TREE_ROW_LIMITS), vec3(seen_from)));
    place.xy = vec2(mirror * card.x / wide, (card.y - low) / (top - low));
    float texels = float(TREE_TILE_HEIGHT) * away * frame.material.y / (high * (top - low));  // in a sample
    if (group) texels *= 0.6;  // its tops are narrow
    float level = clamp(floor(log2(texels) + 0.15), float(TREE_FINEST), float(TREE_LEVELS) - 1.0);
    vec2 tile = vec2(TREE_TILE_WIDTH, TREE_TILE_HEIGHT) * exp2(-level);
    place.zw = tile * vec2(column_of(tree, group) + 0.5 + 0.5 * place.x, row + place.y);

    vec3 before = through_air(vec3(0.0), middle), kept = through_air(vec3(1.0), middle) - before;
    Lights lights = lights_of(tree, front, view, cosine);
    vec4 snows = snow(tree);
    // A load of snow shades needles: bare ones are brighter, or a wood without snow would be a black mass.
    bool leafy = in_leaf(tree);
    hues = leafy ? 1.0 : 0.6;
    vec3 colour = needles(tree) * (leafy ? 2.9 : mix(2.8, 1.0, snows.a)), needle = colour * kept * lights.needle;
    // Needles on the side of the sun are brighter by the sun's share of their light.
    float aside = frame.lamp.g * tree.look.x * 0.83 * mirror * dot(frame.sun.xyz, across) / lights.needle.g;
    dark = vec4(needle, clamp(aside, -0.95, 0.95));
    white = vec4((snows.rgb * kept * lights.snow - needle) * snows.a, mix(0.25, 0.75, tree.kind.z));
    if (leafy) white.rgb = 2.0 * bark(tree) * kept * lights.needle - needle;  // its pictures have bark in place of snow
    air = vec4(before, texels < 0.7 * exp2(float(TREE_FINEST)) ? -1.0 : level - float(TREE_FINEST));
}
