// Flow points: one for each edge, drawn where a front crosses it.
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

void main() {
    gl_PointSize = 5.0 * frame.material.z;
    if (!is_cut(gl_VertexID)) {
        gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // outside the image
        return;
    }
    vec2 at = crossing_of(gl_VertexID);
    gl_Position = frame.clip_from_world * vec4(at, height_at(relief, at), 1.0);
}
