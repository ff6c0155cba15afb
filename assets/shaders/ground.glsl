// Ground and the standing layer on it, wherever it is: the terrain and the mountains around it look the same.
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

// A point on the ground, and the area that a pixel covers there.
struct Place {
    vec3 ray;         // from the eye, as long as one step forward
    float forward;    // steps
    vec3 at;          // m
    vec2 source;      // cells; the place on the grid whose land is drawn here
    vec2 slope;
    float open;       // visible share of the sky
    float footprint;  // m
    float level;      // of the detail texture, if a tile were 1 m wide
};

// The material to be lit.
struct Skin {
    vec3 albedo;
    vec2 rise;   // slope that small relief adds
    float open;  // share of the sky visible from small hollows
    float wet;   // share of it that mirrors the sky, 0 to 1
};

// Small relief at a place, from broad to narrow.
struct Detail {
    vec4 broad, soft, rock, clumps;
    vec2 at;      // m, where finer relief is taken
    float tone;   // 0 to 1, the broadest variation
    vec4 strata;  // of steep ground: tone of its bed, −0.5 to 0.5; how much of a ledge it is, of a joint down its face, of a wet streak, 0 to 1
};

// Tiles of grain and sastrugi: 27 m along the wind, 9 m across.
const mat2 kAlongWind = mat2(0.0292, 0.0681, 0.0227, -0.0876);

Place place_at(vec3 at, vec3 ray, float forward, vec2 slope, float open) {
    Place p;
    p.ray = ray;
    p.forward = forward;
    p.at = at;
    p.source = at.xy / frame.ground.x;
    p.slope = slope;
    p.open = open;
    // At a low viewing angle a pixel covers a long strip: use the mean of its length and width.
    float facing = dot(vec3(-slope, 1.0), ray) / sqrt((1.0 + dot(slope, slope)) * dot(ray, ray));
    p.footprint = forward * frame.material.y * inversesqrt(clamp(-facing, 0.06, 1.0));
    p.level = log2(p.footprint * float(textureSize(detail_texture, 0).x));
    return p;
}

// How places turn into tiles of the detail texture: each use has a direction and a width of its own, in metres, so
// that no two repeat together.
mat2 turned(float c, float s, float width) { return mat2(c, s, -s, c) / width; }

// Small relief at a place: slopes along x and y (about −1 to 1), height and a second, broader height (0 to 1). `width`
// of a tile across, m. Mip-mapped, so what is too fine for a pixel vanishes instead of shimmering.
vec4 detail(Place p, int kind, vec2 at, mat2 to_tiles, float width) {
    float level = p.level - log2(width);
    // Where tiles are seen as small, they lose what would show that they repeat: at the same distance in a coarse image, or
    // rock would change its shape where something begins to move.
    level += 2.0 * max(level - 3.5 - frame.lower_rolling.w, 0.0);
    vec4 t = textureLod(detail_texture, vec3(to_tiles * at, kind), level);
    t.xy = (t.xy * 2.0 - 1.0) * to_tiles * width;
    return mix(vec4(0.0, 0.0, 0.5, 0.5), t, frame.haze.w);
}

// Where a slope is too steep to be textured from above, a place is seen from the side: along the axis that faces it.
bool upright(Place p, float noise) { return dot(p.slope, p.slope) > 1.0 + noise; }
vec2 from_side(Place p) { return abs(p.slope.x) > abs(p.slope.y) ? p.at.yz : p.at.xz; }
// Slopes of relief seen from the side as slopes along x and y.
vec2 to_ground(Place p, vec2 rise) {
    return rise.y * p.slope + (abs(p.slope.x) > abs(p.slope.y) ? vec2(0.0, rise.x) : vec2(rise.x, 0.0));
}

// A number for each bed, 0 to 1.
vec3 of_beds(vec3 number) {
    uvec3 h = uvec3(ivec3(number)) * 0x9E3779B1u;
    h = (h ^ (h >> 15u)) * 0x2C1B3C6Du;
    return vec3((h ^ (h >> 13u)) & 0xFFFFu) / 65535.0;
}

// Beds of rock of three thicknesses, some 40, 11 and 3 m, that dip and wave: tone, and ledge. A ledge is the top of a hard
// bed, from which a softer one has retreated. Joints run down the face, and water from ledges darkens it in streaks.
vec4 strata_at(Place p, Detail d) {
    vec4 folds = detail(p, DETAIL_SOFT, p.at.xy, turned(0.766, 0.643, 270.0), 270.0);
    float bed = dot(p.at, vec3(0.008, 0.005, 0.09)) + 2.0 * d.broad.z + 2.2 * folds.z + 0.8 * d.soft.z + 0.5 * d.rock.z;
    vec3 place = bed * vec3(0.27, 1.0, 3.3) + vec3(0.0, 0.37, 0.71), number = floor(place), up = place - number;
    vec3 below = of_beds(number - 1.0), here = of_beds(number);
    vec3 seen = clamp(1.3 - p.footprint * vec3(0.02, 0.10, 0.40), 0.0, 1.0);
    vec3 tone = mix(below, here, smoothstep(0.0, 0.12, up)) - 0.5;
    vec3 ledge = smoothstep(0.0, 0.05, up) * (1.0 - smoothstep(0.08, 0.40, up)) * smoothstep(0.05, 0.35, below - here);
    // A bed wedges out here and there, and joints break its edge.
    vec3 runs = smoothstep(0.30, 0.65, vec3(d.soft.z, d.soft.w, d.clumps.z) + 0.5 * (of_beds(number + 57.0) - 0.5) + 1.8 * (folds.zwz - 0.52) + 0.7 * (0.4 - d.rock.z));
    vec4 strata = vec4(dot(tone * seen, vec3(0.42, 0.36, 0.22)), dot(ledge * runs * seen, vec3(0.60, 0.50, 0.35)), 0.0, 0.0);
    float steep = smoothstep(0.55, 0.95, dot(p.slope, p.slope));
    if (steep > 0.0) {
        vec2 face = from_side(p) + 3.0 * d.soft.zw;
        float joints = detail(p, DETAIL_ROCK, face * vec2(1.0, 0.30), turned(0.985, 0.174, 29.0), 29.0).z;
        float water = detail(p, DETAIL_SOFT, face * vec2(1.0, 0.07), turned(1.0, 0.0, 21.0), 21.0).z;
        strata.zw = steep * vec2(1.0 - smoothstep(0.12, 0.34, joints), smoothstep(0.50, 0.80, water) * smoothstep(0.42, 0.60, d.soft.w));
    }
    return strata;
}

Detail detail_at(Place p) {
    // Scales from hundreds of metres to centimetres, so that something is seen at any distance. Broad noise bends finer
    // noise, which hides its lattice and its repeats. It bends by little, or its 256 steps would show.
    float widest = 1.0 / frame.eye.w;
    Detail d;
    d.broad = detail(p, DETAIL_SOFT, p.at.xy, turned(0.921, 0.389, widest), widest);
    vec2 at = p.at.xy + (d.broad.zw - 0.5) * (0.06 * widest);
    d.soft = detail(p, DETAIL_SOFT, at, turned(0.267, 0.964, 64.0), 64.0);
    d.tone = mix(d.broad.w, d.soft.w, 0.25);
    at = p.at.xy + (d.soft.zw - 0.5) * 10.0;
    bool side = upright(p, d.soft.z - 0.5);
    d.rock = detail(p, DETAIL_ROCK, side ? from_side(p) : at, turned(-0.588, 0.809, 43.0), 43.0);
    if (side) d.rock.xy = to_ground(p, d.rock.xy);
    d.at = p.at.xy + (d.soft.zw - 0.5) * 4.0;
    d.clumps = detail(p, DETAIL_CLUMPS, d.at, turned(0.980, 0.199, 26.0), 26.0);
    d.strata = dot(p.slope, p.slope) > 0.3 ? strata_at(p, d) * frame.haze.w : vec4(0.0);
    return d;
}

// How much the share of the standing layer exceeds the half at which it hides the ground, patchy.
float thinned(Place p, Detail d, float share) {
    // Noise makes cover patchy up to about four visible depths, and more on steep ground, where rocks poke out. Beyond
    // that it counts a quarter: a flat limit would leave half-covered stains.
    float steep = min(length(p.slope), 1.2);
    float patchy = 0.8 * (d.tone - 0.373) + 0.3 * (d.soft.z - 0.53) + (0.15 + 0.45 * steep) * (d.rock.z - 0.40) + 0.12 * (d.clumps.z - 0.59);
    float most = 0.30 + 0.12 * steep;
    // Rock sheds snow, but for its ledges and hollows.
    float rocky = smoothstep(0.75, 1.15, length(p.slope) + 0.3 * (d.soft.z - 0.5)), snowy = smoothstep(0.55, 0.75, frame.standing.g);
    float held = rocky * frame.haze.w * (2.6 * max(d.strata.y - 0.12, 0.0) + 0.9 * (0.34 - d.rock.z) + 0.3 * (0.42 - d.clumps.z));
    return share - 0.5 - min(patchy, mix(most, patchy, 0.25)) * frame.haze.w + held * (held > 0.0 ? snowy : 1.0);
}

// Where one material ends on another that nothing has touched, as snow does in spring: the border reaches down into
// hollows and gullies and frays into patches. It is taken from a place as far away as this, m: uphill for the upper
// material to reach lower.
vec2 frayed(Place p, Detail d) {
    float most = 0.035 * frame.ground.x * float(max(frame.size.x, frame.size.y));
    float lower = 0.8 * (d.broad.z - 0.5) + 0.8 * (d.tone - 0.4) + 0.6 * (d.soft.z - 0.53) + 0.5 * (0.40 - d.rock.z) + 0.3 * (d.clumps.z - 0.59) + 3.0 * (0.85 - p.open);
    return clamp(lower, -1.0, 1.0) * most * frame.haze.w * p.slope * inversesqrt(0.02 + dot(p.slope, p.slope));
}

// The visible share of the lower of two materials where nothing has touched them: clods and patches of either.
float patchy_share(Detail d, float share) {
    float lump = 1.2 * (d.clumps.z - 0.59) + 0.9 * (d.rock.z - 0.40) + 0.5 * (d.soft.z - 0.53);
    float ragged = clamp((share - 0.5 + 4.0 * lump * share * (1.0 - share)) * 5.0 + 0.5, 0.0, 1.0);
    return mix(share, ragged, frame.haze.w);
}

// Share of rock in bare ground: steep or high. What sticks out of snow is rather rock.
float stony(Place p, Detail d) {
    float altitude = (p.at.z - frame.ground.z) / (frame.ground.w - frame.ground.z), snowy = smoothstep(0.55, 0.75, frame.standing.g);
    return smoothstep(0.50, 0.95, length(p.slope) + 0.5 * (d.broad.z - 0.5) + 0.35 * (d.rock.z - 0.5) + 0.14 * snowy +
                                      (0.35 + 0.5 * snowy) * smoothstep(0.45 - 0.2 * snowy, 1.0, altitude) * frame.haze.w);
}

// The finest scale is that of what lies on top: stone, or grain along the wind.
vec4 fine_at(Place p, Detail d, float covered) {
    bool stone = covered < 0.5 && stony(p, d) > 0.5;
    return detail(p, stone ? DETAIL_ROCK : DETAIL_SOFT, d.at, stone ? turned(0.622, 0.783, 9.0) : kAlongWind, 9.0);
}

// Bare ground: straw-coloured turf with greener hollows, or `plants`, and rock in beds that dip and wave.
Skin ground(Place p, Detail d, vec4 fine, Skin plants) {
    float bare = stony(p, d);
    vec3 grass = frame.meadow.rgb * mix(vec3(0.68, 0.76, 0.72), vec3(1.55, 1.30, 1.15), d.tone);
    grass *= 0.40 + 0.22 * d.soft.z + 0.22 * d.rock.z + 0.20 * d.clumps.z + 0.50 * fine.z;
    float band = 0.9 * d.strata.x, crack = 1.0 - smoothstep(0.10, 0.24, d.rock.z);
    vec3 stone = frame.rock.rgb * (0.42 + 0.70 * d.rock.z + 0.45 * fine.z + band) * (1.0 - 0.45 * crack) * mix(vec3(1.22, 1.0, 0.78), vec3(0.84, 1.0, 1.16), clamp(d.tone + 0.8 * d.strata.x, 0.0, 1.0));
    stone *= (0.72 + 0.56 * d.broad.z) * (1.0 - 0.50 * d.strata.z) * (1.0 - 0.45 * d.strata.w);
    if (!kDated)
        plants = Skin(grass, 0.20 * d.soft.xy + 0.06 * d.clumps.xy + 0.30 * fine.xy, 0.75 + 0.25 * d.soft.z + 0.25 * d.clumps.z, 0.0);
    return Skin(mix(plants.albedo, stone, bare),
                mix(plants.rise, 0.9 * d.rock.xy + 0.5 * fine.xy + 0.5 * d.soft.xy + (0.8 * band - 0.5 * d.strata.y) * p.slope, bare),
                mix(plants.open, 0.60 + 0.8 * d.rock.z, bare), plants.wet);
}

// The standing layer. Wind has combed its grain, in places into sastrugi.
Skin cover(vec3 albedo, Detail d, vec4 fine) {
    // Dark material shows patches, snow hardly does.
    float patchy = 0.06 + 0.9 * max(0.0, 0.7 - albedo.g);
    float tint = 1.0 + patchy * (0.8 * (d.tone - 0.5) + 0.5 * (d.soft.z - 0.5) + 0.4 * (d.rock.z - 0.5) + 0.6 * (fine.z - 0.5));
    float windy = smoothstep(0.25, 0.60, d.tone);
    return Skin(albedo * tint, 0.15 * d.soft.xy + 0.12 * d.broad.xy + 0.03 * d.rock.xy + (0.10 + 0.22 * windy) * fine.xy,
                0.86 + 0.1 * d.soft.z + 0.08 * fine.z, 0.0);
}

// Grass on a standing layer that nothing has touched, or `plants`. `turf`: its colour times its share, and the share.
Skin grown(vec4 turf, Detail d, vec4 fine, Skin plants) {
    if (kDated) return plants;
    vec3 grass = turf.rgb / max(turf.w, 1e-3) * mix(vec3(0.65, 0.75, 0.70), vec3(1.50, 1.25, 1.10), d.tone);
    return Skin(grass * (0.40 + 0.35 * d.soft.z + 0.24 * d.clumps.z + 0.50 * fine.z), 0.2 * d.soft.xy + 0.08 * d.clumps.xy + 0.30 * fine.xy,
                0.75 + 0.25 * d.soft.z + 0.25 * d.clumps.z, 0.0);
}

// Light from crystals that mirror the lamp to the eye, as a factor on it, mostly 0. Each cell of the ground keeps its
// crystal. Cells are as large as a pixel, in powers of two; two sizes are blended, so none appears at once.
float sparkle(Place p) {
    float size = log2(max(1.2 * p.footprint, 0.012)), smaller = floor(size);
    float turn = 40.0 * dot(normalize(p.ray), vec3(0.7, 0.5, 0.3));
    ivec2 cell = ivec2(floor(p.at.xy * exp2(-smaller)));
    vec2 shines = vec2(0.0);
    for (int k = 0; k < 2; ++k) {
        uvec2 c = uvec2(cell >> k);
        uint h = (c.x * 0x9E3779B1u) ^ (c.y * 0x85EBCA77u);
        h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
        h ^= h >> 13;
        float phase = fract(float(h & 0xFFFFu) / 65536.0 + turn);
        shines[k] = (h >> 16) > 65100u ? max(abs(4.0 * phase - 2.0) - 1.0, 0.0) : 0.0;
    }
    return mix(shines.x, shines.y, size - smaller) * smoothstep(0.16, 0.04, p.footprint);
}

// Sky and lamp in water. `wet`: share of the ground that mirrors.
vec3 mirrored(Place p, vec3 normal, float in_sun, float wet) {
    if (!kDated || wet <= 0.0) return vec3(0.0);
    vec3 along = normalize(p.ray), back = reflect(along, normal);
    float past = 1.0 - clamp(-dot(along, normal), 0.0, 1.0), past2 = past * past;
    float mirrors = 0.02 + 0.98 * wet * wet * past2 * past2 * past;  // Schlick (1994); mud is rough
    float up = max(back.z, 0.0), t = max(dot(back, frame.sun.xyz), 0.0), t8 = t * t * t * t * t * t * t * t, t64 = t8 * t8 * t8 * t8 * t8 * t8 * t8 * t8;
    vec3 sky = mix(frame.below.w * horizon(back), frame.zenith.rgb, sqrt(up));
    return wet * mirrors * (sky * p.open + frame.lamp.rgb * (20.0 * t64 * t64 * in_sun));
}

Skin blend(Skin a, Skin b, float share) {
    return Skin(mix(a.albedo, b.albedo, share), mix(a.rise, b.rise, share), mix(a.open, b.open, share), mix(a.wet, b.wet, share));
}
