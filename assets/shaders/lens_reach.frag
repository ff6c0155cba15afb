// Lens: the largest radius of a block of LENS_BLOCK² pixels.
layout(binding = SLOT_COLOUR) uniform sampler2D circles;

out float reach;

void main() {
    ivec2 first = LENS_BLOCK * ivec2(gl_FragCoord.xy), last = min(first + LENS_BLOCK, textureSize(circles, 0));
    reach = 0.0;
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x) reach = max(reach, abs(texelFetch(circles, ivec2(x, y), 0).a));
}
