// Paint of stochastic textures: blends heights before it colours them. It preserves contrast after Heitz and
// Neyret (High-performance by-example noise using a histogram-preserving blending operator, 2018). Their
// operator assumes that its inputs are independent. Sheets that nearly coincide are not, and it would double
// their contrast.
const float kCorrelated = 0.03;  // distance in tiles over which a texture is correlated with itself

float resemblance(Sheet a, Sheet b) {
    vec2 apart = (a.place - b.place) / kCorrelated;
    return 1.0 / (1.0 + dot(apart, apart));
}

Paint paint(Sheet sheets[kSheets], float footprint) {
    const float kHardlySeen = 1.0 / 128.0;
    float level = grain_level(footprint);
    float height = 0.0, variance = 0.0;
    vec2 rise = vec2(0.0);
    for (int s = 0; s < kSheets; ++s) {
        float w = sheets[s].weight;
        if (w < kHardlySeen) continue;
        Grain g = grain_at(sheets[s], level);
        height += w * (g.height - 0.5);
        rise += w * g.rise;
        variance += w * w;
        for (int before = 0; before < s; ++before)
            if (sheets[before].weight >= kHardlySeen)
                variance += 2.0 * w * sheets[before].weight * resemblance(sheets[s], sheets[before]);
    }
    float contrast = inversesqrt(max(variance, 0.05));
    height = 0.5 + height * contrast;
    return Paint(textureLod(paint_colours, vec2(height, 0.5), 0.0).rgb, rise * contrast, 0.65 + 0.7 * height);
}
