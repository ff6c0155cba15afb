// textureGather(), which GLSL ES 3.00 lacks: counter-clockwise from the upper left of the four texels around a place.
ivec2 gathered(ivec2 size, ivec2 at) { return clamp(at, ivec2(0), size - 1); }

vec4 textureGather(sampler2D field, vec2 place, int part) {
    ivec2 size = textureSize(field, 0), at = ivec2(floor(place * vec2(size) - 0.5));
    return vec4(texelFetch(field, gathered(size, at + ivec2(0, 1)), 0)[part], texelFetch(field, gathered(size, at + 1), 0)[part],
                texelFetch(field, gathered(size, at + ivec2(1, 0)), 0)[part], texelFetch(field, gathered(size, at), 0)[part]);
}

uvec4 textureGather(usampler2D field, vec2 place) {
    ivec2 size = textureSize(field, 0), at = ivec2(floor(place * vec2(size) - 0.5));
    return uvec4(texelFetch(field, gathered(size, at + ivec2(0, 1)), 0).r, texelFetch(field, gathered(size, at + 1), 0).r,
                 texelFetch(field, gathered(size, at + ivec2(1, 0)), 0).r, texelFetch(field, gathered(size, at), 0).r);
}
