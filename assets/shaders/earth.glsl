// Bare earth where bedrock was raised or lowered: clods of brown soil, stonier where it was dug out. The more of it there
// is, the less is seen of turf and rock.
layout(binding = SLOT_EARTH) uniform sampler2D earth;

const float kEarthHides = 0.5;  // m, from which nothing else is seen

// Some of it was strewn over what lies on it, which shows where people have built.
vec3 with_dirt(vec3 lies, Place p, Detail d) {
    float rise = abs(spline(earth, p.at.xy / frame.ground.x).value.r);
    float strewn = smoothstep(0.40, 0.85, d.clumps.z + 0.5 * (d.rock.z - 0.4) + 0.4 * (d.soft.z - 0.53));
    return mix(lies, vec3(0.20, 0.145, 0.10), 0.45 * strewn * frame.haze.w * smoothstep(0.1, 1.5, rise));
}

Skin with_earth(Skin skin, Place p, Detail d, vec4 fine) {
    float rise = spline(earth, p.at.xy / frame.ground.x).value.r;
    float ragged = 0.5 * (d.clumps.z - 0.59) + 0.4 * (d.rock.z - 0.40) + 0.3 * (d.soft.z - 0.53);
    float share = abs(rise) / kEarthHides;
    float there = smoothstep(0.15, 0.85, share + 1.6 * ragged * frame.haze.w * share * max(2.0 - share, 0.0));
    vec3 soil = mix(vec3(0.115, 0.075, 0.047), vec3(0.170, 0.122, 0.083), d.tone);
    soil *= 0.45 + 0.55 * d.clumps.z + 0.45 * d.rock.z + 0.35 * (fine.z - 0.5);
    float stones = smoothstep(0.50, 0.72, d.rock.z + 0.25 * (fine.z - 0.5)) * clamp(0.25 - 0.5 * rise, 0.0, 0.7);
    soil = mix(soil, 1.2 * frame.rock.rgb, stones * frame.haze.w);
    return blend(skin, Skin(soil, 0.25 * d.clumps.xy + 0.35 * d.rock.xy + 0.30 * fine.xy, 0.55 + 0.45 * d.clumps.z + 0.15 * d.rock.z, 0.0), there);
}
