// The shadow of a tree: a triangle on the ground, from behind its foot, where it touches, to where the shadow of its top ends, or
// around the ellipse that a round crown casts.
out vec2 along;  // across, −1 to 1 where it is widest; 0 to 1 from foot to tip
flat out vec3 left;  // of the light, where the shadow is darkest
flat out float strength;
flat out vec4 picture;  // of the picture that is its outline: column, level, and the same in the texture; below 0: none, it is too far away; 1: its crown is round

// A triangle around an ellipse from 0.07 to 1.03 of the length, in lengths and in half widths.
#define SHADOW_TIP 1.46
#define SHADOW_BASE 1.89

void main() {
    Tree tree = tree_at(gl_VertexID / 3);
    int corner = gl_VertexID % 3;
    vec2 away = tree.shadow.xy - tree.foot.xy, ahead = away * inversesqrt(max(dot(away, away), 1e-6));
    float side = corner == 0 ? -1.0 : 1.0, radius = tree.look.w;
    vec2 behind = TREE_SHADOW_WIDTH * side * radius * vec2(-ahead.y, ahead.x) - 0.6 * radius * ahead;
    bool tip = corner == 2, is_round = is_broad(tree);
    vec3 at = tip ? tree.shadow.xyz + vec3(0.0, 0.0, 0.6) : tree.foot.xyz + vec3(behind, 0.8);
    along = tip ? vec2(0.0, 1.0) : vec2(side, 0.0);
    if (is_round) {
        at = tree.foot.xyz + (tip ? SHADOW_TIP * (tree.shadow.xyz - tree.foot.xyz) : vec3(SHADOW_BASE * (behind + 0.6 * radius * ahead), 0.0));
        at.z += 0.8;
        along *= vec2(SHADOW_BASE, SHADOW_TIP);
    }
    left = left_by_shadow();
    strength = tree.shadow.w;
    float texels = float(TREE_TILE_HEIGHT) * distance(tree.foot.xyz, frame.eye.xyz) * frame.material.y / (tree.foot.w * TREE_ABOVE);  // in a sample
    float level = max(floor(log2(texels)) + 1.0, float(TREE_FINEST));
    picture = vec4(column_of(tree, tree.kind.y > 1.5), level, level > 2.0 ? -1.0 : level - float(TREE_FINEST), is_round ? 1.0 : 0.0);
    gl_Position = strength > 0.0 ? frame.clip_from_world * vec4(at, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
