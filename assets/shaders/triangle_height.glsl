// Height of the surface at a point, on the triangles that are drawn; m.
float height_at(sampler2D relief, vec2 at) {
    vec2 cell = at / frame.ground.x;
    ivec2 square = clamp(ivec2(cell), ivec2(0), frame.size.xy - 2);
    vec2 f = cell - vec2(square);
    float here = texelFetch(relief, square, 0).r, across = texelFetch(relief, square + 1, 0).r;
    bool lower = f.x >= f.y;
    float aside = texelFetch(relief, square + (lower ? ivec2(1, 0) : ivec2(0, 1)), 0).r;
    return lower ? here + f.x * (aside - here) + f.y * (across - aside)
                 : here + f.y * (aside - here) + f.x * (across - aside);
}
