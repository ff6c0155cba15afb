// Shadow: the height below which the sun is hidden, swept away from the sun in O(vertices).
//
//   sun  \        step 0     the row (or column) nearest to the sun
//         \  ▲    step 1     ceiling₁ = max(ceiling₀, z₀) − fall
//          \/ \   step 2     ceiling₂ = max(ceiling₁, z₁) − fall
//          /   \  …          a place is in shadow where z < ceiling
//
// One thread follows one ray. Rays start half a cell apart and move `shear` cells aside per row, so heights are
// interpolated once and a shadow does not blur on its way.
layout(local_size_x = GROUP_ROW) in;

layout(binding = SLOT_RELIEF) uniform sampler2D relief;
layout(binding = SLOT_SITE) uniform usampler2D site;
layout(binding = IMAGE_SUN_CEILING, r32f) uniform writeonly image2D sun_ceiling;

// Height of a vertex, or the base of the block if it has no ground to cast a shadow.
float height(int column, int row) {
    ivec2 v = frame.sweep.w > 0.5 ? ivec2(row, column) : ivec2(column, row);
    return texelFetch(site, v, 0).r == SITE_DRAIN ? frame.ground.y : texelFetch(relief, v, 0).r;
}

void main() {
    int ray = int(gl_GlobalInvocationID.x);
    if (ray >= frame.size.z) return;
    int rows = frame.size.w;
    int columns = frame.sweep.w > 0.5 ? frame.size.y : frame.size.x;
    float ceiling = frame.ground.y;
    for (int step = 0; step < rows; ++step) {
        imageStore(sun_ceiling, ivec2(ray, step), vec4(ceiling));
        float x = frame.sweep.y + 0.5 * float(ray) + frame.sweep.x * float(step);
        if (x >= 0.0 && x <= float(columns - 1)) {
            int left = min(int(x), columns - 2);
            int row = frame.haze.z > 0.5 ? rows - 1 - step : step;
            ceiling = max(ceiling, mix(height(left, row), height(left + 1, row), x - float(left)));
        }
        ceiling = max(ceiling - frame.sweep.z, frame.ground.y);
    }
}
