// The shadow of a tree: a triangle on the ground, from behind its foot, where it touches, to where the shadow of its top ends.
out vec2 along;  // −1 to 1 across at the foot, 0 at the tip; 0 to 1 from foot to tip
flat out vec3 left;  // of the light, where the shadow is darkest
flat out float strength;
flat out vec3 picture;  // of the picture that is its outline: column, level, and the same in the texture; below 0: none, it is too far away

void main() {
    Tree tree = tree_at(gl_VertexID / 3);
    int corner = gl_VertexID % 3;
    vec2 away = tree.shadow.xy - tree.foot.xy, ahead = away * inversesqrt(max(dot(away, away), 1e-6));
    float side = corner == 0 ? -1.0 : 1.0, radius = tree.look.w;
    vec2 behind = TREE_SHADOW_WIDTH * side * radius * vec2(-ahead.y, ahead.x) - 0.6 * radius * ahead;
    bool tip = corner == 2;
    vec3 at = tip ? tree.shadow.xyz + vec3(0.0, 0.0, 0.6) : tree.foot.xyz + vec3(behind, 0.8);
    along = tip ? vec2(0.0, 1.0) : vec2(side, 0.0);
    left = left_by_shadow();
    strength = tree.shadow.w;
    float texels = float(TREE_TILE_HEIGHT) * distance(tree.foot.xyz, frame.eye.xyz) * frame.material.y / (tree.foot.w * TREE_ABOVE);  // in a sample
    float level = max(floor(log2(texels)) + 1.0, float(TREE_FINEST));
    picture = vec3(column_of(tree, tree.kind.y > 1.5), level, level > 2.0 ? -1.0 : level - float(TREE_FINEST));
    gl_Position = strength > 0.0 ? frame.clip_from_world * vec4(at, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
