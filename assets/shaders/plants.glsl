// Plants and water on ground that nothing has touched, where a date says how far plants are (frame.season).
layout(binding = SLOT_LAND) uniform sampler2D land;  // render/mountain/land.h: brook, moisture, tilled, rubble

// The land at a place of the grid, cells.
vec4 land_at(vec2 cell) {
    vec2 texels = vec2(textureSize(land, 0));
    return textureLod(land, (cell / vec2(frame.size.xy - 1) * (texels - 1.0) + 0.5) / texels, 0.0);
}

// Meadows that are cut at different times, and fields: strips along a valley, each in a tone of its own.
vec3 tilled(vec3 grass, Place p, Detail d, vec4 fine) {
    vec2 at = mat2(0.961, -0.276, 0.276, 0.961) * p.at.xy + 5.0 * (d.broad.zw - 0.5);
    float row = floor(at.y / 78.0);
    vec2 strip = vec2(at.x / (24.0 + 22.0 * of_corner(ivec2(int(row), 7))) + 17.3 * row, at.y / 78.0);
    vec2 within = abs(fract(strip) - 0.5) * vec2(34.0, 78.0);
    float own = of_corner(ivec2(floor(strip))), other = fract(37.0 * own);
    vec3 tone = own < 0.30 ? vec3(1.30, 1.15, 0.90)      // cut some days ago
                : own < 0.42 ? vec3(1.90, 1.40, 1.40)    // hay
                : own < 0.75 ? vec3(0.86, 0.90, 0.80)    // high grass
                             : vec3(1.05, 1.02, 0.95);
    float rows = 0.5 + 0.5 * sin(at.x * (6.2832 / 3.4));
    float seen = clamp(1.2 - p.footprint * 1.6, 0.0, 1.0) * smoothstep(0.35, 0.25, abs(other - 0.5) - 0.1);
    tone *= 1.0 + (own < 0.45 ? 0.16 : 0.05) * (rows - 0.5) * seen;
    float border = smoothstep(0.6, 0.2, min(17.0 - within.x, 39.0 - within.y)) * clamp(1.2 - p.footprint * 1.2, 0.0, 1.0) * smoothstep(0.40, 0.65, d.soft.z + 0.3 * own);
    return mix(grass * mix(vec3(1.0), tone, 0.75 * frame.haze.w), grass * vec3(0.70, 0.78, 0.66), border);
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
    vec3 grass = mix(straw, mix(vec3(0.078, 0.150, 0.026), vec3(0.170, 0.185, 0.045), dry), green);
    float is_tilled = smoothstep(0.35, 0.65, here.b + rugged * 0.25 * (d.soft.z - 0.5));
    grass = mix(grass, tilled(mix(grass, 1.15 * grass, is_tilled), p, d, fine), is_tilled);
    // Dwarf shrubs higher up: dark, rust in autumn.
    float shrubs = smoothstep(0.52, 0.66, 0.55 * d.soft.w + 0.45 * d.clumps.z + 0.35 * (altitude - 0.55) + 0.15 * steep - 0.3 * moist) * rugged * (1.0 - is_tilled);
    grass = mix(grass, mix(mix(vec3(0.060, 0.052, 0.026), vec3(0.050, 0.078, 0.024), green), vec3(0.135, 0.055, 0.024), frame.season.z * frame.season.y), 0.65 * shrubs);
    // Reeds and sedges where it is wet and level.
    float away = LAND_FAR - (LAND_FAR + LAND_NEAR) * here.r;  // m, from the water of a brook
    float wet = max(smoothstep(0.72, 0.88, moist), smoothstep(5.5, 2.5, away + 3.0 * (d.soft.z - 0.5) * rugged));
    float reeds = wet * smoothstep(0.22, 0.12, steep) * (1.0 - is_tilled) * smoothstep(0.35, 0.55, d.clumps.z);
    grass = mix(grass, mix(vec3(0.150, 0.120, 0.055), vec3(0.085, 0.105, 0.030), green), 0.75 * reeds);
    vec4 blades = vec4(0.0, 0.0, 0.5, 0.5);
    if (p.footprint < 0.3) blades = mix(blades, detail(p, DETAIL_CLUMPS, p.at.xy, turned(0.643, 0.766, 1.9), 1.9), rugged * clamp(1.5 - 5.0 * p.footprint, 0.0, 1.0));
    grass = with_flowers(grass, p, d, green * (1.0 - shrubs) * (1.0 - frame.season.z) * mix(1.0, 0.5, is_tilled) * smoothstep(0.9, 0.5, steep));
    // Tufts; cattle tread steps along steep slopes.
    float tufts = 0.34 + 0.24 * d.soft.z + 0.20 * d.rock.z * (1.0 - is_tilled) + 0.30 * d.clumps.z * (1.0 - 0.6 * is_tilled) + 0.52 * fine.z + 0.65 * (blades.z - 0.5);
    float steps = smoothstep(0.30, 0.45, steep) * smoothstep(0.85, 0.65, steep) * smoothstep(0.35, 0.6, d.soft.w) * clamp(1.5 - 1.2 * p.footprint, 0.0, 1.0) * rugged;
    float tread = steps > 0.0 ? smoothstep(0.25, 0.0, abs(fract(p.at.z / 0.9 + 1.6 * d.soft.z + 0.9 * d.clumps.z) - 0.5)) : 0.0;
    grass = mix(grass * tufts, vec3(0.105, 0.080, 0.050), 0.45 * steps * tread);
    Skin skin = Skin(grass, 0.18 * d.soft.xy + (0.10 + 0.35 * shrubs) * d.clumps.xy * (1.0 - is_tilled) + (0.34 - 0.16 * is_tilled) * fine.xy + 0.25 * blades.xy + 0.5 * steps * (0.5 - tread) * p.slope,
                     0.70 + 0.25 * d.soft.z + 0.30 * d.clumps.z - 0.15 * shrubs, 0.0);

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
