// Shadow: the height below which the sun is hidden, swept away from the sun in O(vertices).
//
//   sun  \        step 0     the row (or column) nearest to the sun
//         \  ▲    step 1     ceiling₁ = max(ceiling₀, z₀) − fall
//          \/ \   step 2     ceiling₂ = max(ceiling₁, z₁) − fall
//          /   \  …          a place is in shadow where z < ceiling
//
// One thread follows one ray. Rays start half a cell apart and move `shear` cells aside per row, so heights are
// interpolated once and a shadow does not blur on its way. Outside the block heights are those of the surroundings.
layout(local_size_x = GROUP_ROW) in;

layout(binding = SLOT_RELIEF) uniform sampler2D relief;
layout(binding = SLOT_SITE) uniform usampler2D site;
layout(binding = SLOT_SURROUNDINGS) uniform sampler2D surroundings;
layout(binding = IMAGE_SUN_CEILING, r32f) uniform writeonly image2D sun_ceiling;

const float kReach = 1.8;   // longer sides
const float kSteps = 48.0;

// Height where there is no vertex: of the surroundings, or the base of the block.
float beyond(float column, float row) {
    if (frame.beyond.w < 0.5) return frame.ground.y;
    vec2 at = frame.ground.x * (frame.sweep.w > 0.5 ? vec2(row, column) : vec2(column, row));
    return texture(surroundings, ((at - frame.beyond.xy) / frame.beyond.z + 0.5) / vec2(textureSize(surroundings, 0))).r;
}

// Height of a vertex.
float height(int column, int row) {
    ivec2 v = frame.sweep.w > 0.5 ? ivec2(row, column) : ivec2(column, row);
    return texelFetch(site, v, 0).r == SITE_DRAIN ? beyond(float(column), float(row)) : texelFetch(relief, v, 0).r;
}

void main() {
    int ray = int(gl_GlobalInvocationID.x);
    if (ray >= frame.size.z) return;
    int rows = frame.size.w;
    int columns = frame.sweep.w > 0.5 ? frame.size.y : frame.size.x;
    float ceiling = frame.ground.y;
    float first = frame.sweep.y + 0.5 * float(ray);

    // Surroundings between the sun and the block, in longer steps.
    float stride = kReach * float(max(rows, columns)) / kSteps;  // rows
    for (float step = -kSteps * stride; frame.beyond.w > 0.5 && step < -0.5 * stride; step += stride) {
        float row = frame.haze.z > 0.5 ? float(rows - 1) - step : step;
        ceiling = max(max(ceiling, beyond(first + frame.sweep.x * step, row)) - frame.sweep.z * stride, frame.ground.y);
    }

    for (int step = 0; step < rows; ++step) {
        imageStore(sun_ceiling, ivec2(ray, step), vec4(ceiling));
        float x = first + frame.sweep.x * float(step);
        int row = frame.haze.z > 0.5 ? rows - 1 - step : step;
        if (x >= 0.0 && x <= float(columns - 1)) {
            int left = min(int(x), columns - 2);
            ceiling = max(ceiling, mix(height(left, row), height(left + 1, row), x - float(left)));
        } else {
            ceiling = max(ceiling, beyond(x, float(row)));
        }
        ceiling = max(ceiling - frame.sweep.z, frame.ground.y);
    }
}
