// Surface and walls: an index holds the vertex's x and y, and whether it is on the surface or at the base of
// the block.
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

out vec3 at;        // m
out float below_m;  // depth below the surface, m

void main() {
    ivec2 v = ivec2(gl_VertexID, gl_VertexID >> INDEX_Y_SHIFT) & INDEX_X_MASK;
    bool base = (gl_VertexID & INDEX_BASE) != 0;
    float height = texelFetch(relief, v, 0).r;
    at = vec3(vec2(v) * frame.ground.x, base ? frame.ground.y : height);
    below_m = height - at.z;
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
