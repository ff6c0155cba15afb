// Flow: places the cut mesh on the surface, with the texture coordinates of each side.
layout(binding = SLOT_RELIEF) uniform sampler2D relief;
layout(binding = SLOT_ROLLING) uniform sampler2D rolling;
layout(binding = SLOT_LAYERS) uniform sampler2D layers;
layout(std430, binding = SLOT_FLOW_OFFSETS) readonly buffer FlowOffsets { vec2 offsets[]; };
layout(std430, binding = SLOT_FLOW_MIX) readonly buffer FlowMix { vec4 mixes[]; };
struct OfVertex {
    int beside;     // its index among the gradients
    float deposit;  // m
    int shows;      // vertex whose texture is drawn
    float stretch;  // 0: not stretched
};
layout(std430, binding = SLOT_FLOW_VERTICES) readonly buffer FlowVertices { OfVertex vertices[]; };
layout(std430, binding = SLOT_FLOW_GRADIENTS) readonly buffer FlowGradients { mat2 gradients[]; };

out vec2 at;          // m
out vec4 offset[3];   // of each latency, m: xy the first phase's, zw the second's
out vec4 mixture;     // shares of the second phases; latency
out float stretch;    // 0: not stretched
out float lies;       // amount of deposit, half at the depth that is drawn; 0 to 1
out float gl_CullDistance[1];

vec2 carried_on(int side, int sheet, vec2 way, bool on_front) {
    vec2 own = offsets[6 * vertices[side].shows + sheet];
    return on_front ? own + gradients[6 * vertices[side].beside + sheet] * way : own;
}

ivec2 texel(int side) { return ivec2(side % frame.size.x, side / frame.size.x); }

// Thickness of a deposit, m. Beside the advected texture it may lie where nothing visibly moved.
float deposit(int side) {
    float change = MOST_CHANGE / 127.0 * (255.0 * texelFetch(layers, texel(side), 0).w - 128.0);
    return max(vertices[side].deposit, change);
}

bool is_seen(int side) {
    return int(frame.flow.y) == FLOW_EVERYWHERE || texelFetch(rolling, texel(side), 0).r > frame.rolling.w ||
           deposit(side) > 0.001;
}

void main() {
    CutVertex v = cut_vertex(gl_VertexID);
    at = v.position;
    vec2 way = at - mesh_positions[v.side];
    for (int k = 0; k < 3; ++k)
        offset[k] = vec4(carried_on(v.side, 2 * k, way, v.on_front), carried_on(v.side, 2 * k + 1, way, v.on_front));
    mixture = mixes[vertices[v.side].shows];
    stretch = vertices[v.side].stretch;
    lies = clamp(0.5 * deposit(v.side) / frame.rolling.w, 0.0, 1.0);
    gl_CullDistance[0] = is_seen(v.side) ? 1.0 : -1.0;
    gl_Position = frame.clip_from_world * vec4(at, height_at(relief, at), 1.0);
}
