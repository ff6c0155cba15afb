// A tree that is some pixels high, or a group of them: one triangle around its axis, turned to the eye, lit as if it
// were a cone.
noperspective out vec4 dark;    // light from needles; −1 to 1 across
noperspective out vec4 bright;  // light from snow on them; 0 at the foot to 1 at the top
flat out vec4 shape;  // how much of its outline shows, 0 to 1; tops of a group or else branches from foot to top, below 0; own number; share of snow

// A group is as high as it is up to here from its middle, so that its triangle is higher.
const float kLevel = 0.34;

void main() {
    Tree tree = trees[gl_VertexID / 3];
    int corner = gl_VertexID % 3;
    bool group = tree.kind.y > 1.5;
    vec2 place = corner == 2 ? vec2(0.0, group ? 1.0 / (1.0 - kLevel) : 1.0) : vec2(corner == 0 ? -1.0 : 1.0, 0.0);
    vec3 to_eye = frame.eye.xyz - tree.foot.xyz;
    vec3 across = cross(tree.axis.xyz, to_eye);
    across *= inversesqrt(max(dot(across, across), 1e-6));
    vec3 front = cross(across, tree.axis.xyz);
    vec3 at = tree.foot.xyz + tree.foot.w * place.y * tree.axis.xyz + tree.look.w * place.x * across;
    float round = group ? 0.45 : 0.80;
    vec3 normal = normalize((round * place.x) * across + 0.45 * front + 0.35 * tree.axis.xyz + vec3(0.0, 0.0, 0.2));
    vec3 light, air;
    light_branches(tree, normal, at, min(place.y, 1.0), light, air);
    float branches = 6.0 + floor(4.0 * fract(7.3 * tree.axis.w));
    float metre = 1.0 / (length(to_eye) * frame.material.y * frame.material.z);  // pixels
    float outline = group ? 2.0 * tree.look.w / tree.kind.y : tree.foot.w / branches;
    vec4 white = snow(tree);
    shape = vec4(smoothstep(1.5, 4.0, metre * outline), group ? tree.kind.y : -branches, tree.axis.w, white.a);
    dark = vec4(needles(tree) * light + air, place.x);
    bright = vec4(white.rgb * light + air, place.y);
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
