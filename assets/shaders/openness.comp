// Computes the openness of vertices of the bedrock: of all once per terrain, and of those around what changes.
layout(local_size_x = GROUP_SQUARE, local_size_y = GROUP_SQUARE) in;

layout(binding = IMAGE_OPENNESS, r16f) uniform writeonly image2D openness;

layout(location = 0) uniform ivec2 first_group;

void main() {
    ivec2 v = GROUP_SQUARE * first_group + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(v, frame.size.xy))) return;
    imageStore(openness, v, vec4(openness_at(v)));
}
