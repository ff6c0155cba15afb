// Ground of two materials.
layout(binding = SLOT_MIXTURE) uniform sampler2D mixture;

// 1 where the standing layer is as deep as at tick 0; `change` as in `layers`.
float unchanged(float change) { return clamp(3.0 - abs(255.0 * change - 128.0), 0.0, 1.0); }

// The lower material appears as clods of one in the other, as large as small relief.
vec2 lower_shares(Place p, Detail d, float change) {
    vec2 share = texture(mixture, (p.at.xy / frame.ground.x + 0.5) / vec2(frame.size.xy)).rg;
    float lump = (d.clumps.z - 0.5) + 0.5 * (d.soft.z - 0.5);
    share = clamp(share + 2.4 * lump * share * (1.0 - share) * frame.haze.w, 0.0, 1.0);

    // Where no slide has been, here and there, the border is frayed.
    vec2 there = ((p.at.xy + frayed(p, d)) / frame.ground.x + 0.5) / vec2(frame.size.xy);
    float untouched = unchanged(change) * unchanged(texture(layers, there).w);
    share.x = mix(share.x, patchy_share(d, texture(mixture, there).r), untouched);
    return share;
}
