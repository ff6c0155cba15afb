// Terrain: shades each surface pixel once, from its depth. Ground by slope and altitude, the standing layer
// over it, the rolling layer over that, all lit once; marks on top.
// Depth and place come from scene_depth.glsl and surface_place.glsl.
layout(binding = SLOT_LAYERS) uniform sampler2D layers;

out vec4 colour;

// What slides do here.
struct Slide {
    Smooth layer;  // share of cover, share of rolling layer, speed, change of the standing layer, as in `layers`
    vec3 lies;     // colours of standing and rolling layer
    vec3 rolls;
};

// The wall at which a slab broke off.
struct Crown {
    float near;      // 1 at the wall, 0 where none is near
    vec2 up;         // unit vector to the snow that still stands
    float side;      // m in plan from its upper edge, negative toward the bed
    float height_m;  // of the wall
    float shown;     // share of the wall that a pixel shows
};

// Finds the wall beside a place, and sharpens `layer` there into the snow above it and the bed under it, in
// crown.glsl; crown_none.glsl is for places without one. wall() draws its face; it turns the place's slope.
Crown crown_at(inout Smooth layer, Place p, Detail d);
Skin wall(Skin skin, Crown crown, vec3 lies, Detail d, inout Place p);

// What slides left on the ground, and what rolls over it, in slides.glsl; slides_none.glsl is for places where nothing
// rolls and nothing has changed. `grown`: turf that nothing has touched; `rolls`: the share that is seen of what rolls.
Skin left_by_slides(Skin skin, Skin grown, float turf, Slide slide, Detail d, float covered);
Skin under_flow(Skin skin, Slide slide, Place p, Detail d, float covered, out float rolls);

// Bare earth over bare ground, in earth.glsl; earth_none.glsl is for places where none was sculpted.
// `with_dirt`: the colour of the standing layer on it.
Skin with_earth(Skin skin, Place p, Detail d, vec4 fine);
vec3 with_dirt(vec3 lies, Place p, Detail d);

// Water in the soil, in wet.glsl; wet_none.glsl is for places without.
Skin with_water(Skin skin, Place p, Detail d);

// Draws marks on the ground, in marks.glsl or marks_none.glsl. `light` is the light that white ground
// reflects.
vec3 marked(vec3 seen, Place p, vec3 light);

// The visible share of the lower material, in the standing and rolling layers, in materials_two.glsl;
// materials_one.glsl is for worlds of one material. `change` as in `layers`.
vec2 lower_shares(Place p, Detail d, float change);

void main() {
    Place p = find_place(scene_depth_at(ivec2(gl_FragCoord.xy)));

    Detail d = detail_at(p);

    Smooth smoothed = spline(layers, p.at.xy / frame.ground.x);
    float pixel = p.footprint / frame.ground.x;  // cells
    Crown crown = crown_at(smoothed, p, d);

    float thin = thinned(p, d, smoothed.value.x);
    // The edge is as wide as a pixel, not more: where the cover is evenly thin, a larger pixel must not show more.
    vec2 cover_along = vec2(smoothed.along_x.x, smoothed.along_y.x);
    float cover_slope = length(cover_along);
    float covered = clamp(thin / (0.015 + min(0.035 * p.footprint, 0.2) + pixel * clamp(cover_slope, 0.05, 1.0)) + 0.5, 0.0, 1.0);

    vec2 lower = lower_shares(p, d, smoothed.value.w);
    vec3 lies = frame.standing.rgb * (1.0 - lower.x) + frame.lower_standing.rgb * lower.x;  // exact if unmixed, unlike mix
    vec3 rolling_colour = frame.rolling.rgb * (1.0 - lower.y) + frame.lower_rolling.rgb * lower.y;
    Slide slide = Slide(smoothed, lies, rolling_colour);
    vec4 fine = fine_at(p, d, covered);
    Skin plants = plants_at(p, d, fine);
    Skin skin = blend(with_earth(ground(p, d, fine, plants), p, d, fine), cover(with_dirt(lies, p, d), d, fine), covered);

    vec4 turf = frame.material.w * mix(frame.turf, frame.lower_turf, lower.x);
    skin = left_by_slides(skin, grown(turf, d, fine, plants), turf.w, slide, d, covered);

    // The edge of the cover is thick: ground before it lies in its shade, and its rim is rounded. Where the cover
    // thins out slowly, there is no edge.
    float from_edge = thin / max(cover_slope, 0.15), sharp = smoothstep(0.15, 0.45, cover_slope) * frame.haze.w;
    float shaded = smoothstep(-0.45, 0.0, from_edge) * (1.0 - covered) * sharp;
    float rim = smoothstep(0.45, 0.0, from_edge) * covered * sharp;
    skin.albedo *= 1.0 - 0.40 * shaded;
    skin.open *= 1.0 - 0.40 * shaded;
    skin.rise += rim * 0.8 * cover_along / max(cover_slope, 1e-4);

    skin = wall(skin, crown, lies, d, p);
    skin = with_water(skin, p, d);

    float rolls = 0.0;
    skin = under_flow(skin, slide, p, d, covered, rolls);

    vec3 normal = normalize(vec3(-p.slope - skin.rise, 1.0));
    // Small relief must not catch sun on a self-shadowed slope.
    float facing_sun = smoothstep(-0.05, 0.12, dot(vec3(-p.slope, 1.0), frame.sun.xyz));
    float in_sun = sunlit(p.at) * facing_sun;
    if (kDated) in_sun *= through_clouds(p.at.xy);
    vec3 light = lit(vec3(1.0), normal, in_sun, p.open * clamp(skin.open, 0.0, 1.2));
    // Only snow is as bright as that.
    light += frame.lamp.rgb * (1.5 * sparkle(p) * in_sun * clamp(4.0 * dot(normal, frame.sun.xyz), 0.0, 1.0) * frame.haze.w * smoothstep(0.55, 0.75, skin.albedo.g));
    vec3 seen = frame.overlay.x == OVERLAY_STRETCH && rolls > 0.5 ? light_shown_as(skin.albedo * shade(light)) : through_air(skin.albedo * light + mirrored(p, normal, in_sun, skin.wet), p.at);
    colour = vec4(marked(seen, p, light), 1.0);
}
