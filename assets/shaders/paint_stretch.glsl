// Paint of the overlay: distortion of the textures, greatest over least stretch, in the colours of its
// legend.
float stretch_of(mat2 g) {
    float same = length(vec2(g[0].x + g[1].y, g[0].y - g[1].x)), other = length(vec2(g[0].x - g[1].y, g[0].y + g[1].x));
    return (same + other) / max(abs(same - other), 1e-4);
}

Paint paint(Sheet sheets[kSheets], float footprint) {
    float stretch = 0.0;
    for (int s = 0; s < kSheets; ++s) stretch += sheets[s].weight * stretch_of(sheets[s].gradient);
    vec3 colour = frame.stops[0].rgb;
    for (int i = 1; i < frame.overlay.y; ++i) {
        float from = frame.stops[i - 1].w, to = frame.stops[i].w;
        colour = mix(colour, frame.stops[i].rgb, clamp((stretch - from) / (to - from), 0.0, 1.0));
    }
    return Paint(from_srgb(colour), vec2(0.0), 1.0);
}
