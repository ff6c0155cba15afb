// How much of the ground the standing layer hides, 0 to 1, by its depth (m) and the slope; half at the visible depth.
// Old snow under it lies where the ground is not too steep; it is for the eye alone.
float cover_share(float depth, vec2 slope) {
    const float kHolds = 0.65, kSheds = 1.2;  // slopes up to which old snow is whole, and from which there is none
    float lies = depth + frame.meadow.w * smoothstep(kSheds, kHolds, length(slope));
    return lies / (lies + frame.standing.w);
}
