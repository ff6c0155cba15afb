// Slides: what they left, and what rolls now.
layout(binding = SLOT_SKIN_ALBEDO) uniform sampler2D skin_albedo;
layout(binding = SLOT_SKIN_RELIEF) uniform sampler2D skin_relief;

// The rolling layer: clumps; lighter where it moves fast.
Skin moving(vec3 albedo, Detail d, float speed) {
    float rough = frame.material.x;
    float lump = 0.70 * d.clumps.z + 0.30 * d.soft.z;
    return Skin(albedo * (0.62 + 0.60 * lump + 0.25 * d.broad.w) * (1.0 + 0.12 * speed),
                rough * (1.5 * d.clumps.xy + 0.7 * d.soft.xy + 0.4 * d.broad.xy),
                mix(1.0, 0.40 + 1.1 * lump, rough), 0.0);
}

// The rolling layer's advected texture: weaker than the texture itself, and as uneven overall as the ground. Its blocks stick
// out in places and are buried in others, or far away it would be scales of one size.
Skin worn(Skin carried, vec3 albedo, Detail d) {
    const vec3 kLuminance = vec3(0.21, 0.72, 0.07);
    float rough = frame.material.x, light = dot(carried.albedo, kLuminance) / max(dot(albedo, kLuminance), 1e-3);
    float bare = mix(1.0, mix(0.25, 1.45, smoothstep(0.30, 0.70, 0.6 * d.soft.z + 0.4 * d.clumps.z)), frame.haze.w);
    return Skin(albedo * (mix(1.0, light, rough * min(bare, 1.0)) * (0.85 + 0.3 * d.broad.w)),
                rough * (bare * carried.rise + 0.2 * d.broad.xy + frame.haze.w * (0.35 * d.soft.xy + 0.20 * d.clumps.xy)),
                mix(1.0, carried.open, rough * min(bare, 1.0)), 0.0);
}

// The same for a deposit: nearly the colour of the standing layer, as crushed material is darker.
// It lies in mounds and hollows that are larger than its blocks, and what it tore off lies between these.
Skin at_rest(Skin carried, vec3 rolls, vec3 lies, Detail d) {
    carried.albedo *= mix(lies, rolls, 0.35) / max(rolls, 1e-3);
    float rough = frame.material.x * frame.haze.w, mound = 0.6 * d.clumps.z + 0.4 * d.soft.z;
    carried.rise = carried.rise * (0.70 + 0.60 * mound) + rough * (0.55 * d.clumps.xy + 0.50 * d.soft.xy);
    carried.open *= mix(1.0, 0.75 + 0.45 * mound, rough);
    float dirt = smoothstep(0.45, 0.20, mound) * smoothstep(0.62, 0.30, d.rock.z) * smoothstep(0.95, 0.75, carried.open);
    carried.albedo *= mix(vec3(1.0), vec3(0.72, 0.66, 0.60), 0.55 * dirt * rough);
    return carried;
}

// Soil that flows or has flowed, where plants are drawn: rafts of turf, torn and trodden, and mud that shines where it is wet.
// What is nearly water tears turf to shreds.
Skin with_mud(Skin mud, Detail d, float turf, float fresh) {
    float sheen = frame.rock.w * fresh, pools = smoothstep(0.62, 0.40, d.clumps.z) * smoothstep(0.35, 0.60, d.soft.z + 0.3 * sheen);
    mud.albedo *= 1.0 - 0.42 * sheen * (0.4 + 0.6 * pools);
    mud.rise *= 1.0 - 0.45 * sheen * pools;
    mud.wet = sheen * (0.12 + 0.60 * pools);
    vec3 green = mix(frame.turf.rgb, vec3(0.085, 0.135, 0.028), frame.season.x) * (0.45 + 0.5 * d.clumps.z + 0.3 * d.soft.z);
    float torn = turf * smoothstep(0.75, 0.55, frame.rock.w) * smoothstep(0.30, 0.45, d.rock.z + 0.4 * (d.clumps.z - 0.5));
    mud.albedo = mix(mud.albedo, 0.8 * green, 0.65 * torn);
    mud.rise += 0.25 * torn * d.clumps.xy;
    mud.wet *= 1.0 - torn;
    return mud;
}

// Before its front mud lets go of water, which has wetted the ground there.
Skin with_fringe(Skin skin, float fringe) {
    float wet = frame.rock.w * fringe;
    skin.albedo = mix(skin.albedo, 0.45 * frame.standing.rgb, 0.70 * wet);
    skin.rise *= 1.0 - 0.7 * wet;
    skin.wet = max(skin.wet, 0.45 * wet);
    return skin;
}

Skin left_by_slides(Skin skin, Skin grown, float turf, Slide slide, Detail d, float covered) {
    // Where the standing layer is thinner than at tick 0, a scar: greyed and rough. Where it is thicker, a deposit:
    // debris that lies still, under the advected texture if there is one. Edges are ragged, and no change stays none.
    float change = MOST_CHANGE / 127.0 * (255.0 * slide.layer.value.w - 128.0);  // m
    float rough = smoothstep(0.50, 0.43, -change);  // the bed of a slab is smooth
    change *= 1.0 + frame.haze.w * 1.7 * (d.clumps.z - 0.5);
    float scar = smoothstep(0.01, 0.12, -change) * covered, deposit = smoothstep(0.01, 0.10, change) * covered;
    skin.albedo *= mix(vec3(1.0), vec3(0.90, 0.925, 0.95) + 0.10 * (d.rock.z - 0.5), scar);
    skin.rise += scar * rough * (0.30 * d.rock.xy + 0.20 * d.clumps.xy);
    skin = blend(skin, grown, turf * covered * smoothstep(0.06, 0.03, abs(change)));
    return blend(skin, moving(mix(slide.lies, slide.rolls, 0.35), d, 0.0), deposit);
}

Skin under_flow(Skin skin, Slide slide, Place p, Detail d, float covered, out float rolls) {
    vec4 layer = slide.layer.value;
    vec2 along = vec2(slide.layer.along_x.y, slide.layer.along_y.y);
    float steepness = length(along), pixel = p.footprint / frame.ground.x;
    float share = layer.y + 0.5 * (0.7 * (d.clumps.z - 0.5) + (d.soft.z - 0.5)) * frame.material.x;
    rolls = clamp((share - 0.5) / (0.7 * pixel + 0.02) + 0.5, 0.0, 1.0);

    // Distance from the front, in cells, negative outside: a dark foot before it, a lit lip on it.
    float from_front = (share - 0.5) / max(steepness, 0.15);
    float foot = smoothstep(-0.35, 0.0, from_front) * smoothstep(0.1, 0.35, layer.y) * (1.0 - rolls);
    float lip = smoothstep(0.9, 0.0, from_front) * smoothstep(0.1, 0.3, steepness);
    Skin debris = moving(slide.rolls, d, layer.z);
    if (int(frame.flow.y) != FLOW_NOWHERE) {
        // Material with its advected texture. Frayed detail beyond the cut mesh uses the texture at its
        // place.
        vec4 albedo = texelFetch(skin_albedo, ivec2(gl_FragCoord.xy), 0), rise = texelFetch(skin_relief, ivec2(gl_FragCoord.xy), 0);
        Skin carried = Skin(albedo.rgb, rise.xy, rise.z, 0.0);
        float turf = albedo.a > 0.25 ? 2.0 - 2.0 * albedo.a : 0.0, there = step(0.25, albedo.a);
        if (int(frame.flow.y) == FLOW_EVERYWHERE)
            rolls = albedo.a;
        else if (frame.overlay.x != OVERLAY_STRETCH) {
            carried = worn(carried, slide.rolls, d);
            Skin rests = at_rest(carried, slide.rolls, slide.lies, d);
            if (kDated) {
                carried = with_mud(carried, d, turf, 1.0);
                rests = with_mud(rests, d, turf, 0.6);
            }
            skin = blend(skin, rests, covered * smoothstep(0.1, 0.5, rise.w));
        }
        debris = blend(debris, carried, there);
    }
    debris.rise += lip * (kDated ? 1.5 : 0.9) * along / max(steepness, 1e-4);
    skin = blend(skin, debris, rolls);
    skin.open *= 1.0 - 0.45 * foot;
    skin.albedo *= 1.0 - 0.35 * foot;
    if (kDated) skin = with_fringe(skin, smoothstep(0.24, 0.46, layer.y) * (1.0 - rolls));
    return skin;
}
