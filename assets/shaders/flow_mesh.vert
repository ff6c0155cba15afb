// Flow mesh as lines: its edges, and the front segments among them.
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

out float front;  // 1 along a front

void main() {
    CutVertex v = cut_vertex(gl_VertexID);
    front = v.on_front ? 1.0 : 0.0;
    gl_Position = frame.clip_from_world * vec4(v.position, height_at(relief, v.position), 1.0);
}
