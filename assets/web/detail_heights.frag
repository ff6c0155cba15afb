// Heights of small relief, one layer in each colour: DETAIL_SOFT, DETAIL_ROCK, DETAIL_CLUMPS, and broad noise. They are those
// of render/mountain/detail.cpp and render/base/noise.h.
uniform float texels;  // along an edge of the tile
out vec4 heights;

float hash(int x, int y, int period, uint seed) {
    uvec2 v = uvec2((ivec2(x, y) + period) % period);
    uint h = (v.x * 0x9E3779B1u) ^ (v.y * 0x85EBCA77u) ^ (seed * 0xC2B2AE3Du);
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return float((h ^ (h >> 15)) >> 8) / 16777216.0;
}

float value_noise(vec2 at, int period, uint seed) {
    ivec2 i = ivec2(floor(at));
    vec2 t = at - floor(at);
    t = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    return mix(mix(hash(i.x, i.y, period, seed), hash(i.x + 1, i.y, period, seed), t.x),
               mix(hash(i.x, i.y + 1, period, seed), hash(i.x + 1, i.y + 1, period, seed), t.x), t.y);
}

float fractal_noise(vec2 at, int first, uint seed) {
    float sum = 0.0, weight = 0.5;
    int period = first;
    for (uint octave = 0u; octave < 6u; ++octave) {
        sum += weight * value_noise(at * float(period), period, seed + octave);
        period *= 2;
        weight *= 0.5;
    }
    return sum;
}

float rock(vec2 at) {
    vec2 bent = at + 0.06 * vec2(fractal_noise(at, 4, 91u), fractal_noise(at, 4, 92u));
    float sum = 0.0, weight = 0.55, carry = 1.0;
    int period = 5;
    for (uint octave = 0u; octave < 6u; ++octave) {
        float crest = 1.0 - abs(2.0 * value_noise(bent * float(period), period, 40u + octave) - 1.0);
        sum += weight * crest * crest * carry;
        carry = clamp(1.4 * crest, 0.3, 1.0);
        period *= 2;
        weight *= 0.55;
    }
    return sum;
}

float domes(vec2 at, int period, uint seed) {
    vec2 place = at * float(period);
    ivec2 cell = ivec2(place);
    float highest = 0.0;
    for (int y = cell.y - 1; y <= cell.y + 1; ++y)
        for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
            vec2 away = place - vec2(x, y) - vec2(hash(x, y, period, seed), hash(x, y, period, seed + 1u));
            float radius = 0.45 + 0.5 * hash(x, y, period, seed + 2u);
            highest = max(highest, sqrt(max(radius * radius - dot(away, away), 0.0)));
        }
    return highest;
}

void main() {
    vec2 at = floor(gl_FragCoord.xy) / texels;
    float clumps = 0.55 * domes(at, 14, 7u) + 0.32 * domes(at, 31, 17u) + 0.18 * domes(at, 67, 27u) + 0.2 * fractal_noise(at, 8, 37u);
    heights = vec4(fractal_noise(at, 6, 1u), rock(at), clumps, fractal_noise(at, 3, 71u));
}
