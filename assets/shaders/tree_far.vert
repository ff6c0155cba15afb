// A tree that is some pixels high, or a group of them: one triangle around its axis, out of which tree_far.frag cuts
// branches or tops.
out vec4 dark;    // light from needles; −1 to 1 across
out vec4 bright;  // light from snow on them; 0 at the foot to 1 at the top
flat out vec4 shape;  // outline that shows, 0 to 1; tops of a group or else branches, below 0; own number; share of snow

// A group is as high as it is up to here from its middle, so that its triangle is higher.
const float kLevel = 0.34;

void main() {
    Tree tree = tree_at(gl_VertexID / 3);
    int corner = gl_VertexID % 3;
    bool group = tree.kind.y > 1.5;
    vec2 place = corner == 2 ? vec2(0.0, group ? 1.0 / (1.0 - kLevel) : 1.0) : vec2(corner == 0 ? -1.0 : 1.0, 0.0);
    vec3 at, light, air;
    around_axis(tree, place, tree.look.w, group ? 0.45 : 0.80, at, light, air);
    float branches = 6.0 + floor(4.0 * fract(7.3 * tree.axis.w));
    float metre = 1.0 / (length(frame.eye.xyz - tree.foot.xyz) * frame.material.y * frame.material.z);  // pixels
    float pixels = metre * (group ? 24.0 * tree.look.w / tree.kind.y : tree.foot.w);
    vec4 white = snow(tree);
    float shows = smoothstep(TREE_PLAIN_PIXELS, 2.5 * TREE_PLAIN_PIXELS, pixels);
    shape = vec4(shows, group ? tree.kind.y : -branches, tree.axis.w, white.a);
    dark = vec4(needles(tree) * light + air, place.x);
    bright = vec4(white.rgb * light + air, place.y);
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
