// A layer of the detail texture from its heights: slopes along x and y, height, and broad noise, 0 to 1.
layout(binding = SLOT_DETAIL) uniform sampler2D heights;
layout(binding = SLOT_BEDROCK) uniform sampler2D low;  // one texel: of each colour of the heights
layout(binding = SLOT_DEPTH) uniform sampler2D high;
uniform int layer;
out vec4 texel;

vec4 at(ivec2 place) {
    vec4 lowest = texelFetch(low, ivec2(0), 0), highest = texelFetch(high, ivec2(0), 0);
    return (texelFetch(heights, place & (textureSize(heights, 0) - 1), 0) - lowest) / (highest - lowest);
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    float steepness = layer == DETAIL_SOFT ? 12.0 : 9.0;
    vec2 slope = vec2(at(p + ivec2(1, 0))[layer] - at(p - ivec2(1, 0))[layer], at(p + ivec2(0, 1))[layer] - at(p - ivec2(0, 1))[layer]);
    vec4 here = at(p);
    texel = vec4(0.5 + 0.5 * steepness * slope, here[layer], here.a);
}
