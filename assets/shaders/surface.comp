// Surface: computes the inputs of the drawing passes from the fields. One thread per vertex of each group
// that changed.
layout(local_size_x = GROUP_SQUARE, local_size_y = GROUP_SQUARE) in;

layout(binding = SLOT_VELOCITY_X) uniform sampler2D velocity_x;
layout(binding = SLOT_VELOCITY_Y) uniform sampler2D velocity_y;
layout(binding = SLOT_MIXTURE) uniform sampler2D mixture;
layout(binding = SLOT_OPENNESS) uniform sampler2D openness;
layout(binding = SLOT_PROBABILITY) uniform sampler2D probability;
layout(binding = SLOT_WATER) uniform sampler2D water;
layout(std430, binding = SLOT_SURFACE_GROUPS) readonly buffer Groups { int groups[]; };
layout(binding = IMAGE_RELIEF, rgba32f) uniform writeonly image2D relief;
layout(binding = IMAGE_LAYERS, rgba8) uniform writeonly image2D layers;
layout(binding = IMAGE_MEASURE, rg32f) uniform writeonly image2D measure;

float ground(ivec2 v) { return texelFetch(bedrock, v, 0).r + texelFetch(depth, v, 0).r; }

// The slope of the ground under the rolling layer, as slope() is that of the surface.
float ground_slope(ivec2 v, ivec2 along) {
    bool ahead = is_ground(v + along), behind = is_ground(v - along);
    float rise = ground(ahead ? v + along : v) - ground(behind ? v - along : v);
    return rise / (frame.ground.x * (ahead && behind ? 2.0 : 1.0));
}

// Impact pressure: density times the square of the speed along the slope, kPa.
float pressure(ivec2 v, vec2 velocity) {
    float rise = dot(velocity, vec2(ground_slope(v, ivec2(1, 0)), ground_slope(v, ivec2(0, 1))));
    float lower = frame.lower_standing.w > 0.5 ? texelFetch(mixture, v, 0).g : 0.0;
    return mix(frame.density.x, frame.density.y, lower) * (dot(velocity, velocity) + rise * rise) / 1000.0;
}

// The overlay's value times its weight, and the weight; without an overlay the share of saturation, if soil is wet. Without a rolling layer the weight is 0, so that no
// depth or speed mixes into the front beside it.
vec2 measured(ivec2 v, vec2 rise, float d, float r, float rolls, vec2 velocity) {
    switch (frame.overlay.x) {
        case OVERLAY_SLOPE: return vec2(degrees(atan(length(rise))), 1.0);
        case OVERLAY_STANDING: return vec2(d, 1.0);
        case OVERLAY_ROLLING: return vec2(r, 1.0) * rolls;
        case OVERLAY_SPEED: return vec2(length(velocity), 1.0) * rolls;
        case OVERLAY_PROBABILITY: return vec2(texelFetch(probability, v, 0).r, 1.0);
        case OVERLAY_WATER: return vec2(100.0 * texelFetch(water, v, 0).r, 1.0);
        case OVERLAY_PRESSURE: return vec2(pressure(v, velocity), 1.0) * rolls;
    }
    if (frame.overlay.x == 0 && frame.overlay.w != 0) return vec2(texelFetch(water, v, 0).r, 1.0);
    return vec2(0.0);
}

void main() {
    int number = int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x);
    if (number >= groups.length()) return;
    int group = groups[number];
    ivec2 v = ivec2(group & 0xffff, group >> 16) * GROUP_SQUARE + ivec2(gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(v, frame.size.xy))) return;
    float here = height(v);
    bool known = is_ground(v);
    vec2 rise = known ? vec2(slope(v, ivec2(1, 0), here), slope(v, ivec2(0, 1), here)) : vec2(0);
    imageStore(relief, v, vec4(here, rise, texelFetch(openness, v, 0).r));

    vec2 velocity = vec2(texelFetch(velocity_x, v, 0).r, texelFetch(velocity_y, v, 0).r);
    vec4 shares = layers_at(v, rise, length(velocity));
    imageStore(layers, v, shares);
    float d = texelFetch(depth, v, 0).r, r = texelFetch(rolling, v, 0).r;
    imageStore(measure, v, vec4(known ? measured(v, rise, d, r, shares.y, velocity) : vec2(0.0), 0.0, 0.0));
}
