// Lens: how far a pixel of a block must look to see all that is spread over it, pixels.
layout(binding = SLOT_LENS_REACH) uniform sampler2D reaches;
layout(location = 0) uniform vec4 lens;  // as in lens_circles.frag

out float reach;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(reaches, 0) - 1;
    int around = int(ceil(lens.y / float(LENS_BLOCK)));
    reach = 0.0;
    for (int y = -around; y <= around; ++y)
        for (int x = -around; x <= around; ++x) {
            float radius = texelFetch(reaches, clamp(here + ivec2(x, y), ivec2(0), last), 0).r;
            // Blocks beside each other touch.
            vec2 between = float(LENS_BLOCK) * vec2(max(abs(ivec2(x, y)) - 1, ivec2(0)));
            if (length(between) <= radius) reach = max(reach, radius);
        }
}
