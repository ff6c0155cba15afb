// Wet soil: darker by a third where it is full of water, and shining in its hollows.
layout(binding = SLOT_MEASURE) uniform sampler2D soaked;  // sim::Things::water, 0 to 1, without an overlay

Skin with_water(Skin skin, Place p, Detail d) {
    if (frame.overlay.x != 0 || frame.overlay.w == 0) return skin;
    float share = clamp(spline(soaked, p.at.xy / frame.ground.x).value.r, 0.0, 1.0);
    if (share <= 0.0) return skin;
    // The first of it is drunk by grass and clods unevenly.
    float ragged = 0.7 * (d.clumps.z - 0.55) + 0.5 * (d.soft.z - 0.53);
    float wet = smoothstep(0.0, 0.75, share - 1.6 * ragged * frame.haze.w * share * (1.0 - share));
    skin.albedo *= 1.0 - 0.35 * wet;
    skin.wet = max(skin.wet, wet * (0.12 + 0.45 * smoothstep(0.60, 0.35, d.clumps.z) * frame.haze.w));
    return skin;
}
