layout(binding = SLOT_SUN_CEILING) uniform sampler2D sun_ceiling;

// 1 in the sun, 0 in shadow. The edge is about as wide as the light falls within half a cell. `at` in metres.
float sunlit(vec3 at) {
    vec2 cell = at.xy / frame.ground.x;
    vec2 column_row = frame.sweep.w > 0.5 ? cell.yx : cell;
    float step = frame.haze.z > 0.5 ? float(frame.size.w - 1) - column_row.y : column_row.y;
    float ray = 2.0 * (column_row.x - frame.sweep.x * step - frame.sweep.y);
    float ceiling = texture(sun_ceiling, (vec2(ray, step) + 0.5) / vec2(textureSize(sun_ceiling, 0))).r;
    return smoothstep(-0.5 * frame.sweep.z, 0.0, at.z - ceiling);
}
