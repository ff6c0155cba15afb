// Filters a field of 32-bit floats, which many devices cannot.
vec4 bilinear(sampler2D field, vec2 place) {
    ivec2 size = textureSize(field, 0);
    vec2 at = clamp(place * vec2(size) - 0.5, vec2(0.0), vec2(size - 1));
    ivec2 a = ivec2(at), b = min(a + 1, size - 1);
    vec2 f = at - vec2(a);
    return mix(mix(texelFetch(field, a, 0), texelFetch(field, ivec2(b.x, a.y), 0), f.x),
               mix(texelFetch(field, ivec2(a.x, b.y), 0), texelFetch(field, b, 0), f.x), f.y);
}
