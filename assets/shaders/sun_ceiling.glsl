layout(binding = SLOT_SUN_CEILING) uniform sampler2D sun_ceiling;

// 1 in the sun, 0 in shadow. The edge is about as wide as the light falls within half a cell, under a low sun wider. `at` in
// metres.
float sunlit(vec3 at) {
    vec2 cell = at.xy / frame.ground.x;
    vec2 column_row = frame.sweep.w > 0.5 ? cell.yx : cell;
    float step = frame.haze.z > 0.5 ? float(frame.size.w - 1) - column_row.y : column_row.y;
    float ray = 2.0 * (column_row.x - frame.sweep.x * step - frame.sweep.y);
    float ceiling = texture(sun_ceiling, (vec2(ray, step) + 0.5) / vec2(textureSize(sun_ceiling, 0))).r;
    // The shadow of far crests under a low sun is soft and uneven: ruled edges would tell that these were straight.
    float low = 1.0 - smoothstep(0.03, 0.14, frame.sun.w);
    float soft = 0.012 * low * frame.ground.x * float(max(frame.size.x, frame.size.y));
    float uneven = 0.40 + 0.25 * sin(0.14 * cell.x + 1.3 * sin(0.09 * cell.y)) + 0.15 * sin(0.39 * cell.x + 0.25 * cell.y);
    return smoothstep(-0.5 * frame.sweep.z - soft, 0.0, at.z + soft * uneven - ceiling);
}
