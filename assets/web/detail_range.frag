// The lowest and the highest of each colour in a square of texels.
layout(binding = SLOT_BEDROCK) uniform sampler2D low;
layout(binding = SLOT_DEPTH) uniform sampler2D high;
uniform int edge;  // of the square

layout(location = 0) out vec4 lowest;
layout(location = 1) out vec4 highest;

void main() {
    ivec2 first = edge * ivec2(gl_FragCoord.xy);
    lowest = texelFetch(low, first, 0);
    highest = texelFetch(high, first, 0);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) {
            lowest = min(lowest, texelFetch(low, first + ivec2(x, y), 0));
            highest = max(highest, texelFetch(high, first + ivec2(x, y), 0));
        }
}
