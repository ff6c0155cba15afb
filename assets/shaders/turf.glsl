// Turf that a flow has torn off: it rides on the broad lumps of the advected texture.

// How much a sheet's broad lumps stick out, −0.5 to 0.5: rafts of turf ride on these.
float raft_at(Sheet sheet, float level) {
    const mat2 kBroader = mat2(0.19, 0.07, -0.07, 0.19);  // lumps some five times as wide
    return textureLod(grain, kBroader * sheet.place, max(level - 2.3, 0.0)).z - 0.5;
}

float turf(Sheet sheets[kSheets], float footprint) {
    if (frame.turf.w == 0.0) return 0.0;
    float raft = 0.0, variance = 0.0;
    for (int s = 0; s < kSheets; ++s) {
        if (sheets[s].weight < 1.0 / 64.0) continue;
        raft += sheets[s].weight * raft_at(sheets[s], grain_level(footprint));
        variance += sheets[s].weight * sheets[s].weight;
    }
    return smoothstep(0.10, 0.16, raft * inversesqrt(max(variance, 0.05)));
}
