// Computes the openness of each vertex of the bedrock, once per terrain.
layout(local_size_x = GROUP_SQUARE, local_size_y = GROUP_SQUARE) in;

layout(binding = IMAGE_OPENNESS, r16f) uniform writeonly image2D openness;

void main() {
    ivec2 v = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(v, frame.size.xy))) return;
    imageStore(openness, v, vec4(openness_at(v)));
}
