// Plants and water on ground that nothing has touched, where a date says how far plants are (frame.season).
layout(binding = SLOT_LAND) uniform sampler2D land;  // render/mountain/land.h: brook, moisture, use, rubble

// The land at a place of the grid, cells.
vec4 land_at(vec2 cell) {
    vec2 texels = vec2(textureSize(land, 0));
    return textureLod(land, (cell / vec2(frame.size.xy - 1) * (texels - 1.0) + 0.5) / texels, 0.0);
}

// How people use a place, as shares, from the four texels around it, whose weighted mean is `mean`.
struct Use {
    float field;    // of fields
    float within;   // of the field that covers most of it: 1 within, 0.5 at its edge
    float crop;     // of that field, 0 to 1; see LAND_CROPS
    vec2 along;     // its direction
    float garden, verge, path;
};
Use use_at(vec2 cell, float mean) {
    ivec2 last = textureSize(land, 0) - 1;
    vec2 texel = cell / vec2(frame.size.xy - 1) * vec2(last);
    ivec2 first = clamp(ivec2(floor(texel)), ivec2(0), max(last - 1, ivec2(0)));
    vec2 t = clamp(texel - vec2(first), 0.0, 1.0);
    float code = round(255.0 * texelFetch(land, min(first + ivec2(round(t)), last), 0).b);
    Use use = Use(1.0, 1.0, 0.0, vec2(1.0, 0.0), 0.0, 0.0, 0.0);
    if (abs(255.0 * mean - code) > 0.2 || code >= float(LAND_GARDEN)) {  // else all four are that field
        vec4 uses = round(255.0 * vec4(texelFetch(land, first, 0).b, texelFetch(land, min(first + ivec2(1, 0), last), 0).b,
                                       texelFetch(land, min(first + ivec2(0, 1), last), 0).b, texelFetch(land, min(first + 1, last), 0).b));
        vec4 weights = vec4((1.0 - t.x) * (1.0 - t.y), t.x * (1.0 - t.y), (1.0 - t.x) * t.y, t.x * t.y);
        vec4 fields = weights * step(float(LAND_FIELD), uses) * step(uses, vec4(float(LAND_GARDEN) - 0.5));
        use.field = dot(fields, vec4(1.0)), use.within = 0.0;
        for (int i = 0; i < 4; ++i) {
            float share = dot(fields, vec4(equal(uses, vec4(uses[i]))));
            if (share > use.within) use.within = share, code = uses[i];
        }
        use.garden = dot(weights, vec4(equal(uses, vec4(float(LAND_GARDEN)))));
        use.verge = dot(weights, vec4(equal(uses, vec4(float(LAND_VERGE)))));
        use.path = dot(weights, vec4(equal(uses, vec4(float(LAND_PATH)))));
    }
    code -= float(LAND_FIELD);
    float turn = 3.14159265 / float(LAND_DIRECTIONS) * mod(code, float(LAND_DIRECTIONS));
    use.along = vec2(cos(turn), sin(turn));
    use.crop = (floor(code / float(LAND_DIRECTIONS)) + 0.5) / float(LAND_CROPS);
    return use;
}

// Meadows that are cut at different times, grain, and some ploughed land, in rows along the field.
vec3 field_of(vec3 grass, Use use, Place p, Detail d) {
    float crop = use.crop, near = clamp(1.2 - p.footprint * 1.6, 0.0, 1.0), green = frame.season.x;
    vec3 tone = crop < 0.30 ? vec3(1.30, 1.15, 0.92)      // cut some days ago
                : crop < 0.40 ? vec3(1.75, 1.36, 1.35)    // hay
                : crop < 0.62 ? vec3(0.84, 0.90, 0.76)    // high grass
                : crop < 0.86 ? vec3(1.06, 1.03, 0.95)    // a meadow
                              : vec3(1.0);
    vec3 field = grass * tone;
    float across = dot(p.at.xy, vec2(-use.along.y, use.along.x)) + 0.6 * (d.soft.z - 0.5), strong = crop < 0.40 ? 0.16 : 0.05;
    if (crop > 0.86) {  // grain, ripe in August and stubble then; or ploughed, with green rows
        bool grain = crop < 0.95;
        field = mix(field, grain ? vec3(0.300, 0.255, 0.085) : vec3(0.105, 0.072, 0.044), grain ? 0.62 : 0.55 + 0.35 * (1.0 - green));
        strong = grain ? 0.10 : 0.45;
    }
    float rows = 0.5 + 0.5 * sin(across * (6.2832 / (crop > 0.95 ? 1.3 : 3.2)));
    field *= 1.0 + strong * (rows - 0.5) * (crop > 0.95 ? clamp(1.4 - p.footprint * 3.2, 0.0, 1.0) : near);
    // What no scythe reaches.
    float edge = smoothstep(0.96, 0.66, use.within) * clamp(1.3 - 0.5 * p.footprint, 0.0, 1.0);
    return mix(mix(grass, field, frame.haze.w), grass * vec3(0.70, 0.78, 0.64), edge * (0.55 + 0.45 * d.clumps.z));
}

// Beds of a garden: soil, with plants of a kind in each row.
vec3 garden_at(vec3 grass, Place p, Detail d) {
    vec2 at = mat2(0.94, -0.34, 0.34, 0.94) * p.at.xy / vec2(3.1, 0.6);
    float own = of_corner(ivec2(floor(at))), other = fract(57.0 * own);
    vec3 plant = mix(grass, own < 0.25 ? vec3(0.060, 0.130, 0.050) : own < 0.50 ? vec3(0.120, 0.180, 0.050) : own < 0.57 ? vec3(0.130, 0.095, 0.090) : vec3(0.080, 0.150, 0.035), 0.8 * frame.season.x);
    float row = smoothstep(0.46, 0.26, abs(fract(at.y) - 0.5)) * smoothstep(0.0, 0.3, 0.5 - abs(fract(at.x) - 0.5)) * step(0.12, other) * (0.6 + 0.4 * d.clumps.z);
    return mix(vec3(0.074, 0.056, 0.040) * (0.6 + 0.8 * d.clumps.z), plant, mix(row, 0.55, smoothstep(0.15, 0.5, p.footprint)));
}

// Trodden earth with some gravel; grass is left in the middle of it.
vec3 trodden(vec3 grass, Detail d, float worn) {
    vec3 earth = mix(vec3(0.150, 0.112, 0.072), vec3(0.210, 0.185, 0.150), d.rock.z) * (0.75 + 0.5 * d.clumps.z);
    return mix(grass, earth, worn);
}

// Flowers near the eye, and their shimmer from afar.
vec3 with_flowers(vec3 grass, Place p, Detail d, float many) {
    float patchy = smoothstep(0.45, 0.75, d.soft.w + 0.4 * (d.clumps.z - 0.5));
    many *= patchy;
    vec3 bright = mix(vec3(0.62, 0.50, 0.05), vec3(0.62, 0.60, 0.55), smoothstep(0.45, 0.60, d.broad.w));
    bright = mix(bright, vec3(0.30, 0.16, 0.38), smoothstep(0.62, 0.72, d.soft.z));
    grass = mix(grass, bright, 0.035 * many);
    float size = 0.16, seen = clamp(1.6 - p.footprint / size, 0.0, 1.0);
    if (seen <= 0.0) return grass;
    vec2 cell = p.at.xy / size;
    float own = of_corner(ivec2(floor(cell)));
    vec2 middle = 0.3 + 0.4 * vec2(fract(own * 41.0), fract(own * 97.0));
    float flower = step(1.0 - 0.14 * many, own) * smoothstep(0.34, 0.18, distance(fract(cell), middle));
    return mix(grass, bright, flower * seen);
}

// Grass, heath, reeds, flowers and fields, rubble, and brooks.
Skin plants_at(Place p, Detail d, vec4 fine) {
    if (!kDated) return Skin(vec3(0.0), vec2(0.0), 1.0, 0.0);
    vec4 here = land_at(p.source);
    float green = frame.season.x, steep = length(p.slope), rugged = frame.haze.w;
    float altitude = clamp((p.at.z - frame.ground.z) / (frame.ground.w - frame.ground.z), 0.0, 1.0);
    float moist = clamp(here.g + rugged * (0.5 * (0.5 - d.soft.z) + 0.35 * (0.5 - d.broad.w)), 0.0, 1.0);
    float sunny = clamp(0.5 + 1.1 * p.slope.y * inversesqrt(1.0 + steep * steep), 0.0, 1.0);
    float dry = clamp(0.15 + 0.55 * sunny + 0.35 * altitude - 0.75 * moist + rugged * 0.7 * (d.tone - 0.4), 0.0, 1.0);

    vec3 straw = (frame.turf.w > 0.0 ? frame.turf.rgb : frame.meadow.rgb) * 0.95;
    vec3 grass = mix(straw, mix(vec3(0.070, 0.145, 0.024), vec3(0.160, 0.180, 0.042), dry), green);
    Use use = Use(0.0, 0.0, 0.0, vec2(1.0, 0.0), 0.0, 0.0, 0.0);
    if (here.b > 0.0) use = use_at(p.source, here.b);
    float is_tilled = smoothstep(0.3, 0.7, use.field + use.garden);
    if (use.within > 0.0) grass = mix(grass, field_of(1.12 * grass, use, p, d), smoothstep(0.3, 0.7, use.field));
    // Pastures are a mosaic: mats of pale bristly grass, and dark lush spots where it is fertile.
    float mosaic = 0.9 * (d.rock.z - 0.40) + 0.8 * (d.clumps.z - 0.59) + 0.7 * (d.soft.z - 0.53), wild = rugged * (1.0 - is_tilled);
    grass = mix(grass, mix(straw, vec3(0.172, 0.182, 0.056), green), 0.75 * wild * smoothstep(0.02, 0.30, mosaic + 0.25 * (dry - 0.5)) * smoothstep(0.10, 0.30, steep));
    grass *= mix(vec3(1.0), vec3(0.60, 0.74, 0.66), wild * smoothstep(-0.06, -0.32, mosaic));
    // Dwarf shrubs higher up: dark, rust in autumn.
    float shrubs = smoothstep(0.54, 0.62, 0.45 * d.soft.w + 0.55 * d.clumps.z + 0.35 * (altitude - 0.55) + 0.15 * steep - 0.3 * moist) * rugged * (1.0 - is_tilled);
    grass = mix(grass, mix(mix(vec3(0.060, 0.052, 0.026), vec3(0.050, 0.078, 0.024), green), vec3(0.135, 0.055, 0.024), frame.season.z * frame.season.y), 0.80 * shrubs);
    // Reeds and sedges where it is wet and level.
    float away = LAND_FAR - (LAND_FAR + LAND_NEAR) * here.r;  // m, from the water of a brook
    float wet = max(smoothstep(0.72, 0.88, moist), smoothstep(5.5, 2.5, away + 3.0 * (d.soft.z - 0.5) * rugged));
    float reeds = wet * smoothstep(0.22, 0.12, steep) * (1.0 - is_tilled) * smoothstep(0.35, 0.55, d.clumps.z);
    grass = mix(grass, mix(vec3(0.150, 0.120, 0.055), vec3(0.085, 0.105, 0.030), green), 0.75 * reeds);
    vec4 blades = vec4(0.0, 0.0, 0.5, 0.5);
    if (p.footprint < 0.3) blades = mix(blades, detail(p, DETAIL_CLUMPS, p.at.xy, turned(0.643, 0.766, 1.9), 1.9), rugged * clamp(1.5 - 5.0 * p.footprint, 0.0, 1.0));
    grass = with_flowers(grass, p, d, green * (1.0 - shrubs) * (1.0 - frame.season.z) * mix(1.0, 0.5, is_tilled) * smoothstep(0.9, 0.5, steep));
    // Tufts; cattle tread steps along steep slopes.
    float tufts = 0.24 + 0.24 * d.soft.z + 0.24 * d.rock.z * (1.0 - is_tilled) + 0.46 * d.clumps.z * (1.0 - 0.6 * is_tilled) + 0.52 * fine.z + 0.80 * (blades.z - 0.5);
    float steps = smoothstep(0.30, 0.45, steep) * smoothstep(0.85, 0.65, steep) * smoothstep(0.35, 0.6, d.soft.w) * clamp(1.5 - 1.2 * p.footprint, 0.0, 1.0) * rugged;
    float tread = steps > 0.0 ? smoothstep(0.25, 0.0, abs(fract(p.at.z / 0.9 + 1.6 * d.soft.z + 0.9 * d.clumps.z) - 0.5)) : 0.0;
    grass = mix(grass * tufts, vec3(0.105, 0.080, 0.050), 0.45 * steps * tread);
    Skin skin = Skin(grass, 0.18 * d.soft.xy + 0.16 * wild * smoothstep(0.1, 0.4, steep) * d.rock.xy + (0.26 + 0.45 * shrubs) * d.clumps.xy * (1.0 - is_tilled) + (0.34 - 0.16 * is_tilled) * fine.xy + 0.25 * blades.xy + 0.5 * steps * (0.5 - tread) * p.slope,
                     0.70 + 0.25 * d.soft.z + 0.30 * d.clumps.z - 0.15 * shrubs, 0.0);

    // Gardens, the worn edges of roads, and paths.
    if (use.garden + use.verge + use.path > 0.0) {
        skin.albedo = mix(skin.albedo, garden_at(grass, p, d), smoothstep(0.35, 0.65, use.garden));
        float worn = smoothstep(0.22, 0.62, use.path + 0.30 * (d.clumps.z - 0.5)), beside = 0.85 * smoothstep(0.0, 0.3, use.verge) * smoothstep(0.25, 0.90, use.verge + 0.8 * (d.clumps.z - 0.55) + 0.5 * (d.soft.z - 0.5));
        worn = max(worn, beside);
        skin.albedo = trodden(skin.albedo, d, worn);
        skin.rise *= 1.0 - 0.6 * worn;
        skin.open = mix(skin.open, 1.0, 0.8 * worn);
    }

    // Stones under rock.
    float stones = smoothstep(0.35, 0.6, here.a * smoothstep(0.30, 0.50, steep) + rugged * (0.5 * (d.clumps.z - 0.55) + 0.35 * (d.rock.z - 0.4)));
    if (stones > 0.0) {
        vec3 stone = frame.rock.rgb * (0.62 + 0.55 * d.clumps.z + 0.45 * d.rock.z) * mix(vec3(1.1, 1.0, 0.9), vec3(0.9, 1.0, 1.1), d.tone);
        skin = Skin(mix(skin.albedo, stone, stones), mix(skin.rise, 0.9 * d.clumps.xy + 0.5 * d.rock.xy + 0.3 * fine.xy, stones), mix(skin.open, 0.5 + 0.6 * d.clumps.z, stones), 0.0);
    }

    // A brook: water between stones, and deep green beside it.
    if (away < 6.0) {
        away += rugged * (2.2 * (d.clumps.z - 0.55) + 1.0 * (d.rock.z - 0.4));
        float blurred = max(0.5 * p.footprint, 0.12);
        float beside = smoothstep(5.0, 1.5, away) * green;
        skin.albedo *= mix(vec3(1.0), vec3(0.75, 0.90, 0.70), beside);
        float bank = smoothstep(0.9 + blurred, 0.5 - blurred, away) * smoothstep(0.40, 0.60, d.clumps.z + 0.5 * (d.soft.z - 0.3)), water = smoothstep(0.05 + blurred, 0.05 - blurred, away);
        vec3 gravel = frame.rock.rgb * (0.55 + 0.75 * d.clumps.z + 0.5 * (fine.z - 0.5));
        skin = Skin(mix(skin.albedo, gravel, bank), mix(skin.rise, 0.7 * d.clumps.xy + 0.4 * fine.xy, bank), mix(skin.open, 0.45 + 0.5 * d.clumps.z, bank), 0.0);
        // It foams where it falls.
        float foam = smoothstep(0.15, 0.5, steep) * smoothstep(0.35, 0.65, 0.6 * fine.z + 0.5 * d.clumps.z);
        vec3 bed = mix(vec3(0.020, 0.035, 0.034), vec3(0.40, 0.44, 0.45), 0.75 * foam);
        skin = Skin(mix(skin.albedo, bed, water), mix(skin.rise, (0.10 + 0.25 * foam) * fine.xy + 0.05 * d.clumps.xy, water), mix(skin.open, 1.0, water), water * (1.0 - 0.6 * foam));
    }
    return skin;
}
