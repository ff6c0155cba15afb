// Terrain: shades each surface pixel once, from its depth. Ground by slope and altitude, the standing layer
// over it, the rolling layer over that, all lit once; marks on top.
layout(binding = SLOT_SCENE_DEPTH) uniform sampler2D scene_depth;
layout(binding = SLOT_RELIEF) uniform sampler2D relief;
layout(binding = SLOT_LAYERS) uniform sampler2D layers;
layout(binding = SLOT_MIXTURE) uniform sampler2D mixture;
layout(binding = SLOT_SKIN_ALBEDO) uniform sampler2D skin_albedo;
layout(binding = SLOT_SKIN_RELIEF) uniform sampler2D skin_relief;

in vec2 ndc;
out vec4 colour;

// Draws marks on the ground, in marks.glsl or marks_none.glsl. `light` is the light that white ground
// reflects.
vec3 marked(vec3 seen, Place p, vec3 light);

// With two materials: the visible share of the lower one, in the standing and rolling layers. It appears as
// clods of one in the other, as large as small relief.
vec2 lower_shares(Place p, Detail d) {
    vec2 share = texture(mixture, (p.at.xy / frame.ground.x + 0.5) / vec2(frame.size.xy)).rg;
    float lump = (d.clumps.z - 0.5) + 0.5 * (d.soft.z - 0.5);
    return clamp(share + 2.4 * lump * share * (1.0 - share) * frame.haze.w, 0.0, 1.0);
}

// The rolling layer: clumps; lighter where it moves fast.
Skin moving(vec3 albedo, Detail d, float speed) {
    float rough = frame.material.x;
    float lump = 0.70 * d.clumps.z + 0.30 * d.soft.z;
    return Skin(albedo * (0.62 + 0.60 * lump + 0.25 * d.broad.w) * (1.0 + 0.12 * speed),
                rough * (1.5 * d.clumps.xy + 0.7 * d.soft.xy + 0.4 * d.broad.xy),
                mix(1.0, 0.40 + 1.1 * lump, rough));
}

// The rolling layer's advected texture: weaker than the texture itself, and as uneven overall as the ground.
Skin worn(Skin carried, vec3 albedo, Detail d) {
    const vec3 kLuminance = vec3(0.21, 0.72, 0.07);
    float rough = frame.material.x, light = dot(carried.albedo, kLuminance) / max(dot(albedo, kLuminance), 1e-3);
    return Skin(albedo * (mix(1.0, light, rough) * (0.85 + 0.3 * d.broad.w)), rough * (carried.rise + 0.2 * d.broad.xy),
                mix(1.0, carried.open, rough));
}

// The same for a deposit: nearly the colour of the standing layer, as crushed material is darker.
Skin at_rest(Skin carried, vec3 rolls, vec3 lies) {
    carried.albedo *= mix(lies, rolls, 0.35) / max(rolls, 1e-3);
    return carried;
}

Place find_place(float depth) {
    vec3 ray = frame.ray_forward.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz;
    float forward = frame.ray_forward.w / depth;
    vec3 at = frame.eye.xyz + ray * forward;
    vec4 r = texture(relief, (at.xy / frame.ground.x + 0.5) / vec2(frame.size.xy));
    return place_at(at, ray, forward, r.yz, r.w);
}

void main() {
    Place p = find_place(texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r);

    Detail d = detail_at(p);

    Smooth smoothed = spline(layers, p.at.xy / frame.ground.x);
    vec4 layer = smoothed.value;
    vec2 along = vec2(smoothed.along_x.y, smoothed.along_y.y);
    float steepness = length(along);
    float pixel = p.footprint / frame.ground.x;  // cells

    float thin = thinned(p, d, layer.x);
    // The edge is as wide as a pixel, not more: where the cover is evenly thin, a larger pixel must not show more.
    vec2 cover_along = vec2(smoothed.along_x.x, smoothed.along_y.x);
    float cover_slope = length(cover_along);
    float covered = clamp(thin / (0.015 + min(0.035 * p.footprint, 0.2) + pixel * clamp(cover_slope, 0.05, 1.0)) + 0.5, 0.0, 1.0);
    float share = layer.y + 0.5 * (0.7 * (d.clumps.z - 0.5) + (d.soft.z - 0.5)) * frame.material.x;
    float rolls = clamp((share - 0.5) / (0.7 * pixel + 0.02) + 0.5, 0.0, 1.0);

    vec2 lower = frame.lower_standing.w > 0.0 ? lower_shares(p, d) : vec2(0.0);
    vec3 lies = frame.standing.rgb * (1.0 - lower.x) + frame.lower_standing.rgb * lower.x;  // exact if unmixed, unlike mix
    vec3 rolling_colour = frame.rolling.rgb * (1.0 - lower.y) + frame.lower_rolling.rgb * lower.y;
    vec4 fine = fine_at(p, d, covered);
    Skin skin = blend(ground(p, d, fine), cover(lies, d, fine), covered);

    // What slides left. Where the standing layer is thinner than at tick 0, a scar: greyed and rough. Where it is
    // thicker, a deposit: debris that lies still, under the advected texture if there is one. Edges are ragged, and
    // no change stays none.
    float change = MOST_CHANGE / 127.0 * (255.0 * layer.w - 128.0);  // m
    change *= 1.0 + frame.haze.w * 1.7 * (d.clumps.z - 0.5);
    float scar = smoothstep(0.01, 0.12, -change) * covered, deposit = smoothstep(0.01, 0.10, change) * covered;
    skin.albedo *= mix(vec3(1.0), vec3(0.90, 0.925, 0.95) + 0.10 * (d.rock.z - 0.5), scar);
    skin.rise += scar * (0.30 * d.rock.xy + 0.20 * d.clumps.xy);
    vec4 turf = frame.material.w * mix(frame.turf, frame.lower_turf, lower.x);
    skin = blend(skin, grown(turf, d, fine), turf.w * covered * smoothstep(0.06, 0.03, abs(change)));
    skin = blend(skin, moving(mix(lies, rolling_colour, 0.35), d, 0.0), deposit);

    // The edge of the cover is thick: ground before it lies in its shade, and its rim is rounded. Where the cover
    // thins out slowly, there is no edge.
    float from_edge = thin / max(cover_slope, 0.15), sharp = smoothstep(0.15, 0.45, cover_slope) * frame.haze.w;
    float shaded = smoothstep(-0.45, 0.0, from_edge) * (1.0 - covered) * sharp;
    float rim = smoothstep(0.45, 0.0, from_edge) * covered * sharp;
    skin.albedo *= 1.0 - 0.40 * shaded;
    skin.open *= 1.0 - 0.40 * shaded;
    skin.rise += rim * 0.8 * cover_along / max(cover_slope, 1e-4);

    // Distance from the front, in cells, negative outside: a dark foot before it, a lit lip on it.
    float from_front = (share - 0.5) / max(steepness, 0.15);
    float foot = smoothstep(-0.35, 0.0, from_front) * smoothstep(0.1, 0.35, layer.y) * (1.0 - rolls);
    float lip = smoothstep(0.9, 0.0, from_front) * smoothstep(0.1, 0.3, steepness);
    Skin debris = moving(rolling_colour, d, layer.z);
    if (int(frame.flow.y) != FLOW_NOWHERE) {
        // Material with its advected texture. Frayed detail beyond the cut mesh uses the texture at its
        // place.
        vec4 albedo = texelFetch(skin_albedo, ivec2(gl_FragCoord.xy), 0), rise = texelFetch(skin_relief, ivec2(gl_FragCoord.xy), 0);
        Skin carried = Skin(albedo.rgb, rise.xy, rise.z);
        if (int(frame.flow.y) == FLOW_EVERYWHERE)
            rolls = albedo.a;
        else if (frame.overlay.x != OVERLAY_STRETCH) {
            carried = worn(carried, rolling_colour, d);
            skin = blend(skin, at_rest(carried, rolling_colour, lies), covered * smoothstep(0.1, 0.5, rise.w));
        }
        debris = blend(debris, carried, albedo.a);
    }
    debris.rise += lip * 0.9 * along / max(steepness, 1e-4);
    skin = blend(skin, debris, rolls);
    skin.open *= 1.0 - 0.45 * foot;
    skin.albedo *= 1.0 - 0.35 * foot;

    vec3 normal = normalize(vec3(-p.slope - skin.rise, 1.0));
    // Small relief must not catch sun on a self-shadowed slope.
    float facing_sun = smoothstep(-0.05, 0.12, dot(vec3(-p.slope, 1.0), frame.sun.xyz));
    float in_sun = sunlit(p.at) * facing_sun;
    vec3 light = lit(vec3(1.0), normal, in_sun, p.open * clamp(skin.open, 0.0, 1.2));
    // Only snow is as bright as that.
    light += frame.lamp.rgb * (1.5 * sparkle(p) * in_sun * clamp(4.0 * dot(normal, frame.sun.xyz), 0.0, 1.0) * frame.haze.w * smoothstep(0.55, 0.75, skin.albedo.g));
    vec3 seen = frame.overlay.x == OVERLAY_STRETCH && rolls > 0.5 ? light_shown_as(skin.albedo * shade(light)) : through_air(skin.albedo * light, p.at);
    colour = vec4(marked(seen, p, light), 1.0);
}
