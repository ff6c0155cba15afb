// Stars: at most one in each cell of a cube around the eye, so that they stay where they are as the camera moves.
const float kCells = 44.0;  // along an edge of the cube: about two degrees each

// Four random numbers, 0 to 1, from a cell (pcg4d: Jarzynski and Olano 2020, "Hash functions for GPU rendering").
vec4 random(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v += v.yzxy * v.wxyz;
    v ^= v >> 16u;
    v += v.yzxy * v.wxyz;
    return vec4(v >> 8u) / 16777216.0;
}

vec3 stars(vec3 direction) {
    vec3 size = abs(direction);
    bool x = size.x >= max(size.y, size.z), y = !x && size.y >= size.z;
    vec3 turned = x ? direction.yzx : y ? direction.zxy : direction;  // z is the axis of the face
    uint face = (x ? 0u : y ? 2u : 4u) + (turned.z > 0.0 ? 1u : 0u);
    vec2 place = (turned.xy / abs(turned.z) * 0.5 + 0.5) * kCells;
    vec4 star = random(uvec4(uvec2(place), face, 17u));
    // Keep away from the cell's edge, which would cut a star in two.
    vec2 from = (fract(place) - mix(vec2(0.25), vec2(0.75), star.xy)) * (2.0 / kCells);
    float radius = max(0.0011, 0.75 * frame.material.y * frame.material.z);
    float spot = max(1.0 - dot(from, from) / (radius * radius), 0.0);
    // Few are bright. Their colour goes from warm to blue.
    float bright = star.z * star.z;
    bright *= bright * bright;
    vec3 tint = mix(vec3(1.0, 0.86, 0.72), vec3(0.78, 0.88, 1.0), star.w);
    return tint * (frame.above.w * (0.10 + 1.1 * bright) * spot * smoothstep(0.0, 0.12, direction.z));
}
