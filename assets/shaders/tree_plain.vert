// A tree that is a few pixels high, or a group of them: one triangle around its axis, turned to the eye. Its outline and
// its snow are the means of those in tree_far.frag.
out vec3 reflected;

void main() {
    Tree tree = tree_at(gl_VertexID / 3);
    int corner = gl_VertexID % 3;
    bool group = tree.kind.y > 1.5;
    vec2 place = corner == 2 ? vec2(0.0, 1.0) : vec2(corner == 0 ? -1.0 : 1.0, 0.0);
    float half_width = tree.look.w * (group ? TREE_GROUP_AS_TRIANGLE : TREE_MEAN_OUTLINE);
    vec3 at, light, air;
    around_axis(tree, place, half_width, group ? 0.45 : 0.80, at, light, air);
    vec4 white = snow(tree);
    reflected = mix(needles(tree), white.rgb, TREE_MEAN_SNOW * white.a) * light + air;
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
