// The shadow of a tree: a triangle on the ground, from its foot to where the shadow of its top ends.
out float along;
flat out vec3 left;  // of the light, where the shadow is darkest
flat out float strength;

void main() {
    Tree tree = tree_at(gl_VertexID / 3);
    int corner = gl_VertexID % 3;
    vec2 away = tree.shadow.xy - tree.foot.xy;
    vec2 side = vec2(-away.y, away.x) * inversesqrt(max(dot(away, away), 1e-6));
    bool tip = corner == 2;
    float radius = tree.look.w * (corner == 0 ? -0.9 : 0.9);
    vec3 at = tip ? tree.shadow.xyz + vec3(0.0, 0.0, 0.6) : tree.foot.xyz + vec3(side * radius, 0.8);
    along = tip ? 1.0 : 0.0;
    left = left_by_shadow();
    strength = tree.shadow.w;
    gl_Position = strength > 0.0 ? frame.clip_from_world * vec4(at, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
