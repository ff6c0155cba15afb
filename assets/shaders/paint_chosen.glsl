// Paint of structured textures. Blended shapes would show through each other, so each place shows one sheet,
// and transitions follow the shapes.
Paint paint(Sheet sheets[kSheets], float footprint) {
    const float kHardlySeen = 1.0 / 64.0;
    float level = grain_level(footprint);
    int best = 0;
    float most = -1.0;
    Grain seen;
    for (int s = 0; s < kSheets; ++s) {
        if (sheets[s].weight < kHardlySeen) continue;
        Grain g = grain_at(sheets[s], level);
        float claim = sheets[s].weight * (0.6 + 0.8 * g.height);
        if (claim > most) {
            most = claim;
            best = s;
            seen = g;
        }
    }
    return Paint(textureLod(paint_colours, sheets[best].place, level).rgb, seen.rise, 0.65 + 0.35 * seen.height);
}
