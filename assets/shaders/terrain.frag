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
    float level;      // of the detail texture, if a tile were 1 m wide
};

// The material to be lit.
struct Skin {
    vec3 albedo;
    vec2 rise;   // slope that small relief adds
    float open;  // share of the sky visible from small hollows
};

// Tiles of grain and sastrugi: 27 m along the wind, 9 m across.
const mat2 kAlongWind = mat2(0.0292, 0.0681, 0.0227, -0.0876);

// Draws marks on the ground, in marks.glsl or marks_none.glsl. `light` is the light that white ground
// reflects.
vec3 marked(vec3 seen, Place p, vec3 light);

// How places turn into tiles of the detail texture: each use has a direction and a width of its own, in metres, so
// that no two repeat together.
mat2 turned(float c, float s, float width) { return mat2(c, s, -s, c) / width; }

// Small relief at a place: slopes along x and y (about −1 to 1), height and a second, broader height (0 to 1). `width`
// of a tile across, m. Mip-mapped, so what is too fine for a pixel vanishes instead of shimmering.
vec4 detail(Place p, float kind, vec2 at, mat2 to_tiles, float width) {
    vec4 t = textureLod(detail_texture, vec3(to_tiles * at, kind), p.level - log2(width));
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

// Share of rock in bare ground: steep or high.
float stony(Place p, vec4 broad, vec4 rock) {
    float altitude = (p.at.z - frame.ground.z) / (frame.ground.w - frame.ground.z);
    return smoothstep(0.50, 0.95, length(p.slope) + 0.5 * (broad.z - 0.5) + 0.35 * (rock.z - 0.5) +
                                      0.35 * smoothstep(0.45, 1.0, altitude) * frame.haze.w);
}

// Bare ground: straw-coloured turf with greener hollows, and rock in beds that dip and wave.
Skin ground(Place p, float bare, float tone, vec4 broad, vec4 soft, vec4 rock, vec4 clumps, vec4 fine) {
    vec3 grass = frame.meadow.rgb * mix(vec3(0.68, 0.76, 0.72), vec3(1.55, 1.30, 1.15), tone);
    grass *= 0.40 + 0.22 * soft.z + 0.22 * rock.z + 0.20 * clumps.z + 0.50 * fine.z;
    float bed = dot(p.at, vec3(0.008, 0.005, 0.09)) + 2.0 * broad.z + 0.8 * soft.z + 0.4 * rock.z;
    vec2 beds = abs(fract(bed * vec2(1.0, 3.7)) * 2.0 - 1.0) - 0.5;  // two thicknesses
    beds *= clamp(vec2(1.3, 1.2) - p.footprint * vec2(0.12, 0.45), 0.0, 1.0) * frame.haze.w;
    float band = 0.26 * beds.x + 0.22 * beds.y;
    vec3 stone = frame.rock.rgb * (0.42 + 0.75 * rock.z + 0.45 * fine.z + band) * mix(vec3(1.10, 1.0, 0.88), vec3(0.92, 1.0, 1.09), tone);
    return Skin(mix(grass, stone, bare),
                mix(0.20 * soft.xy + 0.06 * clumps.xy + 0.30 * fine.xy, 0.8 * rock.xy + 0.5 * fine.xy + 1.5 * band * p.slope, bare),
                mix(0.75 + 0.25 * soft.z + 0.25 * clumps.z, 0.60 + 0.8 * rock.z, bare));
}

// With two materials: the visible share of the lower one, in the standing and rolling layers. It appears as
// clods of one in the other, as large as small relief.
vec2 lower_shares(Place p, vec4 soft, vec4 clumps) {
    vec2 share = texture(mixture, (p.at.xy / frame.ground.x + 0.5) / vec2(frame.size.xy)).rg;
    float lump = (clumps.z - 0.5) + 0.5 * (soft.z - 0.5);
    return clamp(share + 2.4 * lump * share * (1.0 - share) * frame.haze.w, 0.0, 1.0);
}

// The standing layer. Wind has combed its grain, in places into sastrugi.
Skin cover(vec3 albedo, float tone, vec4 broad, vec4 soft, vec4 rock, vec4 fine) {
    // Dark material shows patches, snow hardly does.
    float patchy = 0.06 + 0.9 * max(0.0, 0.7 - albedo.g);
    float tint = 1.0 + patchy * (0.8 * (tone - 0.5) + 0.5 * (soft.z - 0.5) + 0.4 * (rock.z - 0.5) + 0.6 * (fine.z - 0.5));
    float windy = smoothstep(0.25, 0.60, tone);
    return Skin(albedo * tint, 0.15 * soft.xy + 0.12 * broad.xy + 0.03 * rock.xy + (0.10 + 0.22 * windy) * fine.xy,
                0.86 + 0.1 * soft.z + 0.08 * fine.z);
}

// Grass on a standing layer that nothing has touched. `turf`: its colour times its share, and the share.
Skin grown(vec4 turf, float tone, vec4 soft, vec4 clumps, vec4 fine) {
    vec3 grass = turf.rgb / max(turf.w, 1e-3) * mix(vec3(0.65, 0.75, 0.70), vec3(1.50, 1.25, 1.10), tone);
    return Skin(grass * (0.40 + 0.35 * soft.z + 0.24 * clumps.z + 0.50 * fine.z), 0.2 * soft.xy + 0.08 * clumps.xy + 0.30 * fine.xy,
                0.75 + 0.25 * soft.z + 0.25 * clumps.z);
}

// The rolling layer: clumps; lighter where it moves fast.
Skin moving(vec3 albedo, vec4 broad, vec4 soft, vec4 clumps, float speed) {
    float rough = frame.material.x;
    float lump = 0.70 * clumps.z + 0.30 * soft.z;
    return Skin(albedo * (0.62 + 0.60 * lump + 0.25 * broad.w) * (1.0 + 0.12 * speed),
                rough * (1.5 * clumps.xy + 0.7 * soft.xy + 0.4 * broad.xy),
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
    p.level = log2(p.footprint * float(textureSize(detail_texture, 0).x));
    return p;
}

void main() {
    Place p = find_place(texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r);

    // Scales from hundreds of metres to centimetres, so that something is seen at any distance. Broad noise bends finer
    // noise, which hides its lattice and its repeats. It bends by little, or its 256 steps would show.
    float widest = 1.0 / frame.eye.w;
    vec4 broad = detail(p, DETAIL_SOFT, p.at.xy, turned(0.921, 0.389, widest), widest);
    vec2 at = p.at.xy + (broad.zw - 0.5) * (0.06 * widest);
    vec4 soft = detail(p, DETAIL_SOFT, at, turned(0.267, 0.964, 64.0), 64.0);
    float tone = mix(broad.w, soft.w, 0.25);
    at = p.at.xy + (soft.zw - 0.5) * 10.0;
    bool side = upright(p, soft.z - 0.5);
    vec4 rock = detail(p, DETAIL_ROCK, side ? from_side(p) : at, turned(-0.588, 0.809, 43.0), 43.0);
    if (side) rock.xy = to_ground(p, rock.xy);
    at = p.at.xy + (soft.zw - 0.5) * 4.0;
    vec4 clumps = detail(p, DETAIL_CLUMPS, at, turned(0.980, 0.199, 26.0), 26.0);

    Smooth smoothed = spline(layers, p.at.xy / frame.ground.x);
    vec4 layer = smoothed.value;
    vec2 along = vec2(smoothed.along_x.y, smoothed.along_y.y);
    float steepness = length(along);
    float pixel = p.footprint / frame.ground.x;  // cells

    // Noise makes cover patchy up to about four visible depths, and more on steep ground, where rocks poke out. Beyond
    // that it counts a quarter: a flat limit would leave half-covered stains.
    float steep = min(length(p.slope), 1.2);
    float patchy = 0.8 * (tone - 0.373) + 0.3 * (soft.z - 0.53) + (0.15 + 0.45 * steep) * (rock.z - 0.40) + 0.12 * (clumps.z - 0.59);
    float most = 0.30 + 0.12 * steep;
    float thin = layer.x - 0.5 - min(patchy, mix(most, patchy, 0.25)) * frame.haze.w;
    // The edge is as wide as a pixel, not more: where the cover is evenly thin, a larger pixel must not show more.
    vec2 cover_along = vec2(smoothed.along_x.x, smoothed.along_y.x);
    float cover_slope = length(cover_along);
    float covered = clamp(thin / (0.015 + min(0.02 * p.footprint, 0.2) + pixel * clamp(cover_slope, 0.05, 1.0)) + 0.5, 0.0, 1.0);
    float share = layer.y + 0.5 * (0.7 * (clumps.z - 0.5) + (soft.z - 0.5)) * frame.material.x;
    float rolls = clamp((share - 0.5) / (0.7 * pixel + 0.02) + 0.5, 0.0, 1.0);

    vec2 lower = frame.lower_standing.w > 0.0 ? lower_shares(p, soft, clumps) : vec2(0.0);
    vec3 lies = frame.standing.rgb * (1.0 - lower.x) + frame.lower_standing.rgb * lower.x;  // exact if unmixed, unlike mix
    vec3 rolling_colour = frame.rolling.rgb * (1.0 - lower.y) + frame.lower_rolling.rgb * lower.y;
    // The finest scale is that of what lies on top: stone, or grain along the wind.
    float bare = stony(p, broad, rock);
    bool stone = covered < 0.5 && bare > 0.5;
    vec4 fine = detail(p, stone ? DETAIL_ROCK : DETAIL_SOFT, at, stone ? turned(0.622, 0.783, 9.0) : kAlongWind, 9.0);
    Skin skin = blend(ground(p, bare, tone, broad, soft, rock, clumps, fine), cover(lies, tone, broad, soft, rock, fine), covered);

    // What slides left. Where the standing layer is thinner than at tick 0, a scar: greyed and rough. Where it is
    // thicker, a deposit: debris that lies still, under the advected texture if there is one. Edges are ragged, and
    // no change stays none.
    float change = MOST_CHANGE / 127.0 * (255.0 * layer.w - 128.0);  // m
    change *= 1.0 + frame.haze.w * 1.7 * (clumps.z - 0.5);
    float scar = smoothstep(0.01, 0.12, -change) * covered, deposit = smoothstep(0.01, 0.10, change) * covered;
    skin.albedo *= mix(vec3(1.0), vec3(0.90, 0.925, 0.95) + 0.10 * (rock.z - 0.5), scar);
    skin.rise += scar * (0.30 * rock.xy + 0.20 * clumps.xy);
    vec4 turf = frame.material.w * mix(frame.turf, frame.lower_turf, lower.x);
    skin = blend(skin, grown(turf, tone, soft, clumps, fine), turf.w * covered * smoothstep(0.06, 0.03, abs(change)));
    skin = blend(skin, moving(mix(lies, rolling_colour, 0.35), broad, soft, clumps, 0.0), deposit);

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
    float foot = smoothstep(-0.7, 0.0, from_front) * smoothstep(0.0, 0.2, layer.y) * (1.0 - rolls);
    float lip = smoothstep(0.9, 0.0, from_front) * smoothstep(0.1, 0.3, steepness);
    Skin debris = moving(rolling_colour, broad, soft, clumps, layer.z);
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
    float in_sun = sunlit(p.at) * facing_sun;
    vec3 light = lit(vec3(1.0), normal, in_sun, p.open * clamp(skin.open, 0.0, 1.2));
    // Only snow is as bright as that.
    light += frame.lamp.rgb * (1.5 * sparkle(p) * in_sun * clamp(4.0 * dot(normal, frame.sun.xyz), 0.0, 1.0) * frame.haze.w * smoothstep(0.55, 0.75, skin.albedo.g));
    vec3 seen = frame.overlay.x == OVERLAY_STRETCH && rolls > 0.5 ? light_shown_as(skin.albedo * shade(light)) : through_air(skin.albedo * light, p.at);
    colour = vec4(marked(seen, p, light), 1.0);
}
