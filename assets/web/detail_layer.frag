// A layer of the detail texture from its heights: slopes along x and y, height, and broad noise, 0 to 1.
layout(binding = SLOT_DETAIL) uniform sampler2D heights;
uniform int layer;
uniform vec4 lowest, span;  // of each colour of the heights
out vec4 texel;

float at(ivec2 place, int part) {
    return (texelFetch(heights, place & (textureSize(heights, 0) - 1), 0)[part] - lowest[part]) / span[part];
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    float steepness = layer == DETAIL_SOFT ? 12.0 : 9.0;
    vec2 slope = vec2(at(p + ivec2(1, 0), layer) - at(p - ivec2(1, 0), layer), at(p + ivec2(0, 1), layer) - at(p - ivec2(0, 1), layer));
    texel = vec4(0.5 + 0.5 * steepness * slope, at(p, layer), at(p, 3));
}
