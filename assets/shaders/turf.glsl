// Soil that flows is of many sizes: blocks, lumps and fines by place, on the broad lumps of the advected texture; turf that it has
// torn off rides on these.

const mat2 kBroader = mat2(0.19, 0.07, -0.07, 0.19);  // lumps some five times as wide

float sorted(inout Paint seen, Sheet sheets[kSheets], float footprint) {
    float lump = 0.0, variance = 0.0, level = max(grain_level(footprint) - 2.3, 0.0);
    vec2 rise = vec2(0.0);
    for (int s = 0; s < kSheets; ++s) {
        if (sheets[s].weight < 1.0 / 64.0) continue;
        vec3 t = textureLod(grain, kBroader * sheets[s].place, level).xyz;
        lump += sheets[s].weight * (t.z - 0.5);
        rise += sheets[s].weight * (transpose(4.94 * kBroader * sheets[s].gradient) * (t.xy * 255.0 - 128.0));
        variance += sheets[s].weight * sheets[s].weight;
    }
    float contrast = inversesqrt(max(variance, 0.05));
    lump *= contrast;
    // Blocks stand out, with fewer lumps on them; between them are fines, smooth and darker.
    float block = smoothstep(-0.02, 0.10, lump), fines = smoothstep(-0.02, -0.14, lump);
    seen.rise *= 1.0 - 0.40 * block - 0.65 * fines;
    seen.rise += (0.15 + 1.15 * block) * contrast * (STEEPEST_GRAIN / 127.0) * rise;
    seen.open = mix(seen.open, 0.92, 0.35 * block + 0.6 * fines) - 0.12 * fines;
    seen.albedo *= 1.0 + 0.10 * block - 0.16 * fines;
    return frame.turf.w == 0.0 ? 0.0 : smoothstep(0.10, 0.16, lump);
}
