// The uniforms of powder; they match PowderBlock in render/passes/powder_pass.cpp.
layout(std140, binding = SLOT_POWDER) uniform Powder {
    vec4 colour;   // of the upper material, linear light; w: mean radius of a puff, m
    vec4 lower_colour; // of the lower one; w: 1 if there is any of it
    vec4 across;   // of the shade map: a place p is at (dot(across.xyz, p) + across.w, dot(up.xyz, p) + up.w)
    vec4 up;
    ivec4 divisor; // of the resolution
    vec4 coarse;   // width and height of the frame, coarse pixels; a sample in coarse pixels; 0
    vec4 lit;      // a coarse pixel in the texture of the lit cloud, 0 to 1, along x and y; the middle of its last one
    vec4 shadow;   // share of each colour that shaded ground loses less than of red; share of red that it loses
} powder;

#define POWDER_TILE 0.10 // of the detail, across a radius of a puff

// A place at a distance along the view, in m. ndc: −1 to 1.
vec3 place_at(vec2 ndc, float distance_m) {
    vec3 ray = frame.ray_middle.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz;
    return frame.eye.xyz + distance_m * ray;
}
