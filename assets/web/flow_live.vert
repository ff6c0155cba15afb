// Flow: places the cut mesh on the surface, as flow.vert, of vertices that the module has cut (render/flow/flow_mesh.h).
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

layout(location = 0) in vec2 place;       // m
layout(location = 1) in vec4 offsets_0;   // of each latency, m
layout(location = 2) in vec4 offsets_1;
layout(location = 3) in vec4 offsets_2;
layout(location = 4) in vec4 mixes;       // shares of the second phases; latency
layout(location = 5) in vec2 state;       // stretch; deposit, m

out vec2 at;
out vec4 offset[3];
out vec4 mixture;
out float stretch;
out float lies;

void main() {
    at = place;
    offset = vec4[](offsets_0, offsets_1, offsets_2);
    mixture = mixes;
    stretch = state.x;
    lies = clamp(0.5 * state.y / frame.rolling.w, 0.0, 1.0);
    gl_Position = frame.clip_from_world * vec4(at, height_at(relief, at), 1.0);
}
