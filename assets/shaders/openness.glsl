// Openness: the share of the sky that a vertex of the bedrock sees, from its horizon in twelve directions. Hollows
// of one cell to a tenth of the grid, which hardly raise a horizon, count more than they hide.
layout(binding = SLOT_BEDROCK) uniform sampler2D bedrock;
layout(binding = SLOT_SITE) uniform usampler2D site;

const int kDirections = 12;
const float kReach = 0.25;  // of the longer side; farther terrain hardly raises a horizon
const float kHollow = 3.0;  // weight of hollows, by the mean tangent of their sides

// How far the ground rises from a vertex on both sides of it, beyond its slope: the mean tangent over one, two,
// four … cells in four directions. Above 0 in a hollow, below 0 on a ridge.
float hollow(ivec2 v, float here) {
    float sum = 0.0;
    int count = 0;
    for (int cells = 1; cells <= max(4, max(frame.size.x, frame.size.y) / 10); cells *= 2) {
        for (int i = 0; i < 4; ++i) {
            ivec2 along = cells * ivec2(i == 3 ? 0 : 1, i == 3 ? 1 : i - 1);  // SE, E, NE, N
            ivec2 a = v + along, b = v - along;
            if (any(lessThan(min(a, b), ivec2(0))) || any(greaterThanEqual(max(a, b), frame.size.xy))) continue;
            if (texelFetch(site, a, 0).r == uint(SITE_DRAIN) || texelFetch(site, b, 0).r == uint(SITE_DRAIN)) continue;
            float rise = 0.5 * (texelFetch(bedrock, a, 0).r + texelFetch(bedrock, b, 0).r) - here;
            sum += rise / (frame.ground.x * length(vec2(along)));
            ++count;
        }
    }
    return count > 0 ? sum / float(count) : 0.0;
}

float openness_at(ivec2 v) {
    float here = texelFetch(bedrock, v, 0).r;
    float reach = kReach * float(max(frame.size.x, frame.size.y));
    float open = 0.0;
    for (int i = 0; i < kDirections; ++i) {
        float angle = 6.2831853 * (float(i) + 0.5) / float(kDirections);
        vec2 direction = vec2(cos(angle), sin(angle));
        float horizon = 0.0;  // tangent
        for (float cells = 1.5; cells < reach; cells *= 1.45) {
            ivec2 there = v + ivec2(round(direction * cells));
            if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, frame.size.xy))) break;
            if (texelFetch(site, there, 0).r == uint(SITE_DRAIN)) continue;
            float rise = texelFetch(bedrock, there, 0).r - here;
            horizon = max(horizon, rise / (frame.ground.x * length(vec2(there - v))));
        }
        open += 1.0 / (1.0 + horizon * horizon);  // cos² of the horizon's elevation
    }
    open *= (1.0 - kHollow * hollow(v, here)) / float(kDirections);
    return clamp(open, 0.0, 1.0);
}
