// Terrain: shades each surface pixel once, from its depth. Ground by slope and altitude, the standing layer
// over it, the rolling layer over that, all lit once; marks on top.
layout(binding = SLOT_SCENE_DEPTH) uniform sampler2D scene_depth;
layout(binding = SLOT_RELIEF) uniform sampler2D relief;
layout(binding = SLOT_LAYERS) uniform sampler2D layers;
layout(binding = SLOT_MIXTURE) uniform sampler2D mixture;
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;
layout(binding = SLOT_SKIN_ALBEDO) uniform sampler2D skin_albedo;
layout(binding = SLOT_SKIN_RELIEF) uniform sampler2D skin_relief;

in vec2 ndc;
out vec4 colour;

// A point on the surface, and the area that a pixel covers there.
struct Place {
    vec3 ray;         // from the eye, as long as one step forward
    float forward;    // steps
    vec3 at;          // m
    vec2 slope;
    float open;       // visible share of the sky
    float footprint;  // m
};

// The material to be lit.
struct Skin {
    vec3 albedo;
    vec2 rise;   // slope that small relief adds
    float open;  // share of the sky visible from small hollows
};

// Draws marks on the ground, in marks.glsl or marks_none.glsl. `light` is the light that white ground
// reflects.
vec3 marked(vec3 seen, Place p, vec3 light);

// Small relief at a place: slopes along x and y (about −1 to 1), height and a second height (0 to 1).
// Mip-mapped, so it fades with distance instead of shimmering. Each use is rotated by its own angle, which
// hides the repeats.
vec4 detail(Place p, float kind, float scale, float c, float s) {
    mat2 rotation = mat2(c, s, -s, c);
    float repeats = frame.eye.w * scale;
    float level = log2(p.footprint * repeats * float(textureSize(detail_texture, 0).x)) - 0.4;
    vec4 t = textureLod(detail_texture, vec3(rotation * p.at.xy * repeats + c, kind), level);
    t.xy = (t.xy * 2.0 - 1.0) * rotation;
    return mix(vec4(0.0, 0.0, 0.5, 0.5), t, frame.haze.w);
}

Skin ground(Place p, vec4 broad, vec4 soft, vec4 rock, vec4 fine) {
    float altitude = (p.at.z - frame.ground.z) / (frame.ground.w - frame.ground.z);
    float bare = smoothstep(0.50, 0.95, length(p.slope) + 0.5 * (broad.z - 0.5) + 0.35 * (rock.z - 0.5) +
                                            0.35 * smoothstep(0.45, 1.0, altitude) * frame.haze.w);
    float warm = broad.w;
    vec3 grass = frame.meadow.rgb * mix(vec3(0.55, 0.68, 0.62), vec3(1.55, 1.32, 1.2), warm) * (0.55 + 0.9 * soft.z);
    vec3 stone = frame.rock.rgb * (0.40 + 0.75 * rock.z + 0.45 * fine.z) * mix(vec3(1.08, 1.0, 0.90), vec3(0.93, 1.0, 1.08), warm);
    return Skin(mix(grass, stone, bare), mix(0.25 * soft.xy + 0.15 * fine.xy, 0.8 * rock.xy + 0.5 * fine.xy, bare),
                mix(0.80 + 0.4 * soft.z, 0.60 + 0.8 * rock.z, bare));
}

// With two materials: the visible share of the lower one, in the standing and rolling layers. It appears as
// clods of one in the other, as large as small relief.
vec2 lower_shares(Place p, vec4 soft, vec4 clumps) {
    vec2 share = texture(mixture, (p.at.xy / frame.ground.x + 0.5) / vec2(frame.size.xy)).rg;
    float lump = (clumps.z - 0.5) + 0.5 * (soft.z - 0.5);
    return clamp(share + 2.4 * lump * share * (1.0 - share) * frame.haze.w, 0.0, 1.0);
}

Skin cover(vec3 albedo, vec4 broad, vec4 soft, vec4 rock, vec4 fine) {
    // Dark material shows patches, snow hardly does.
    float patchy = 0.08 + 0.9 * max(0.0, 0.7 - albedo.g);
    float tint = 1.0 + patchy * (0.8 * (broad.w - 0.5) + 0.5 * (soft.z - 0.5) + 0.4 * (rock.z - 0.5));
    return Skin(albedo * tint, 0.15 * soft.xy + 0.14 * broad.xy + 0.04 * rock.xy + 0.04 * fine.xy, 0.9 + 0.1 * soft.z);
}

// Grass on a standing layer that nothing has touched. `turf`: its colour times its share, and the share.
Skin grown(vec4 turf, vec4 broad, vec4 soft, vec4 fine, vec4 crumbs) {
    vec3 grass = turf.rgb / max(turf.w, 1e-3) * mix(vec3(0.65, 0.75, 0.70), vec3(1.50, 1.25, 1.10), broad.w);
    return Skin(grass * (0.50 + 0.45 * soft.z + 0.60 * crumbs.z), 0.2 * soft.xy + 0.2 * fine.xy, 0.80 + 0.3 * soft.z);
}

// The rolling layer: clumps at two scales; lighter where it moves fast.
Skin moving(vec3 albedo, vec4 broad, vec4 soft, vec4 clumps, vec4 crumbs, float speed) {
    float rough = frame.material.x;
    float lump = 0.45 * clumps.z + 0.25 * crumbs.z + 0.30 * soft.z;
    return Skin(albedo * (0.62 + 0.60 * lump + 0.25 * broad.w) * (1.0 + 0.12 * speed),
                rough * (1.2 * clumps.xy + 0.6 * crumbs.xy + 0.7 * soft.xy + 0.4 * broad.xy),
                mix(1.0, 0.40 + 1.1 * lump, rough));
}

// The rolling layer's advected texture: weaker than the texture itself, and as uneven overall as the ground.
Skin worn(Skin carried, vec3 albedo, vec4 broad) {
    const vec3 kLuminance = vec3(0.21, 0.72, 0.07);
    float rough = frame.material.x, light = dot(carried.albedo, kLuminance) / max(dot(albedo, kLuminance), 1e-3);
    return Skin(albedo * (mix(1.0, light, rough) * (0.85 + 0.3 * broad.w)), rough * (carried.rise + 0.2 * broad.xy),
                mix(1.0, carried.open, rough));
}

// The same for a deposit: nearly the colour of the standing layer, as crushed material is darker.
Skin at_rest(Skin carried, vec3 rolls, vec3 lies) {
    carried.albedo *= mix(lies, rolls, 0.35) / max(rolls, 1e-3);
    return carried;
}

Skin blend(Skin a, Skin b, float share) {
    return Skin(mix(a.albedo, b.albedo, share), mix(a.rise, b.rise, share), mix(a.open, b.open, share));
}

Place find_place(float depth) {
    vec3 ray = frame.ray_forward.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz;
    Place p;
    p.ray = ray;
    p.forward = frame.ray_forward.w / depth;
    p.at = frame.eye.xyz + ray * p.forward;
    vec4 r = texture(relief, (p.at.xy / frame.ground.x + 0.5) / vec2(frame.size.xy));
    p.slope = r.yz;
    p.open = r.w;
    // At a low viewing angle a pixel covers a long strip: use the mean of its length and width.
    float facing = dot(vec3(-r.yz, 1.0), ray) / sqrt((1.0 + dot(r.yz, r.yz)) * dot(ray, ray));
    p.footprint = p.forward * frame.material.y * inversesqrt(clamp(-facing, 0.06, 1.0));
    return p;
}

void main() {
    Place p = find_place(texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r);

    vec4 broad = detail(p, DETAIL_SOFT, 0.31, 0.921, 0.389), soft = detail(p, DETAIL_SOFT, 1.9, 0.267, 0.964);
    vec4 rock = detail(p, DETAIL_ROCK, 0.8, -0.588, 0.809), fine = detail(p, DETAIL_ROCK, 3.1, 0.622, 0.783);
    vec4 clumps = detail(p, DETAIL_CLUMPS, 0.8, 0.980, 0.199), crumbs = detail(p, DETAIL_CLUMPS, 2.6, -0.129, 0.992);

    Smooth smoothed = spline(layers, p.at.xy / frame.ground.x);
    vec4 layer = smoothed.value;
    vec2 along = vec2(smoothed.along_x.y, smoothed.along_y.y);
    float steepness = length(along);
    float pixel = p.footprint / frame.ground.x;  // cells

    float thin = layer.x - 0.30 * (rock.z + 0.5 * fine.z - 0.75) * length(p.slope);
    // The edge is as wide as a pixel, not more: where the cover is evenly thin, a larger pixel must not show more.
    vec2 cover_along = vec2(smoothed.along_x.x, smoothed.along_y.x);
    float cover_slope = length(cover_along);
    float covered = clamp((thin - 0.5) / (0.03 + pixel * clamp(cover_slope, 0.05, 1.0)) + 0.5, 0.0, 1.0);
    float share = layer.y + 0.5 * (0.5 * (clumps.z - 0.5) + 0.3 * (crumbs.z - 0.5) + (soft.z - 0.5)) * frame.material.x;
    float rolls = clamp((share - 0.5) / (0.7 * pixel + 0.02) + 0.5, 0.0, 1.0);

    vec2 lower = frame.lower_standing.w > 0.0 ? lower_shares(p, soft, clumps) : vec2(0.0);
    vec3 lies = mix(frame.standing.rgb, frame.lower_standing.rgb, lower.x);
    vec3 rolling_colour = mix(frame.rolling.rgb, frame.lower_rolling.rgb, lower.y);
    Skin skin = blend(ground(p, broad, soft, rock, fine), cover(lies, broad, soft, rock, fine), covered);

    // What slides left. Where the standing layer is thinner than at tick 0, a scar: greyed and rough. Where it is
    // thicker, a deposit: debris that lies still, under the advected texture if there is one. Edges are ragged, and
    // no change stays none.
    float change = MOST_CHANGE / 127.0 * (255.0 * layer.w - 128.0);  // m
    change *= 1.0 + frame.haze.w * (1.2 * (clumps.z - 0.5) + 0.8 * (crumbs.z - 0.5));
    float scar = smoothstep(0.01, 0.12, -change) * covered, deposit = smoothstep(0.01, 0.10, change) * covered;
    skin.albedo *= mix(vec3(1.0), vec3(0.90, 0.925, 0.95) + 0.10 * (rock.z - 0.5), scar);
    skin.rise += scar * (0.30 * rock.xy + 0.20 * crumbs.xy);
    vec4 turf = frame.material.w * mix(frame.turf, frame.lower_turf, lower.x);
    skin = blend(skin, grown(turf, broad, soft, fine, crumbs), turf.w * covered * smoothstep(0.06, 0.03, abs(change)));
    skin = blend(skin, moving(mix(lies, rolling_colour, 0.35), broad, soft, clumps, crumbs, 0.0), deposit);

    // The edge of the cover is thick: ground before it lies in its shade, and its rim is rounded. Where the cover
    // thins out slowly, there is no edge.
    float from_edge = (thin - 0.5) / max(cover_slope, 0.15), sharp = smoothstep(0.15, 0.45, cover_slope) * frame.haze.w;
    float shaded = smoothstep(-0.45, 0.0, from_edge) * (1.0 - covered) * sharp;
    float rim = smoothstep(0.45, 0.0, from_edge) * covered * sharp;
    skin.albedo *= 1.0 - 0.40 * shaded;
    skin.open *= 1.0 - 0.40 * shaded;
    skin.rise += rim * 0.8 * cover_along / max(cover_slope, 1e-4);

    // Distance from the front, in cells, negative outside: a dark foot before it, a lit lip on it.
    float from_front = (share - 0.5) / max(steepness, 0.15);
    float foot = smoothstep(-0.7, 0.0, from_front) * smoothstep(0.0, 0.2, layer.y) * (1.0 - rolls);
    float lip = smoothstep(0.9, 0.0, from_front) * smoothstep(0.1, 0.3, steepness);
    Skin debris = moving(rolling_colour, broad, soft, clumps, crumbs, layer.z);
    if (int(frame.flow.y) != FLOW_NOWHERE) {
        // Material with its advected texture. Frayed detail beyond the cut mesh uses the texture at its
        // place.
        vec4 albedo = texelFetch(skin_albedo, ivec2(gl_FragCoord.xy), 0), rise = texelFetch(skin_relief, ivec2(gl_FragCoord.xy), 0);
        Skin carried = Skin(albedo.rgb, rise.xy, rise.z);
        if (int(frame.flow.y) == FLOW_EVERYWHERE)
            rolls = albedo.a;
        else if (frame.overlay.x != OVERLAY_STRETCH) {
            carried = worn(carried, rolling_colour, broad);
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
    vec3 light = lit(vec3(1.0), normal, sunlit(p.at) * facing_sun, p.open * clamp(skin.open, 0.0, 1.2));
    vec3 seen = frame.overlay.x == OVERLAY_STRETCH && rolls > 0.5 ? light_shown_as(skin.albedo * shade(light)) : through_air(skin.albedo * light, p.at);
    colour = vec4(marked(seen, p, light), 1.0);
}
