// Lens: colour of a pixel, and the radius in pixels to which the lens spreads it, below 0 in front of what is sharp.
layout(binding = SLOT_COLOUR) uniform sampler2D frame_colour;
layout(binding = SLOT_SCENE_DEPTH) uniform sampler2D scene_depth;
layout(location = 0) uniform vec4 lens;  // radius far away, largest radius, focus / near plane, samples along a pixel

out vec4 colour;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int samples = int(lens.w);
    // Of its samples the nearest: so the outline of what is sharp keeps its colour.
    float depth = 0.0;
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x)
            depth = max(depth, texelFetch(scene_depth, samples * pixel + ivec2(x, y), 0).r);
    float radius = clamp(lens.x * (1.0 - lens.z * depth), -lens.y, lens.y);
    colour = vec4(texelFetch(frame_colour, pixel, 0).rgb, radius);
}
