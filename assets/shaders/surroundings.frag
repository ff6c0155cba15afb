// Mountains around the block: untouched ground, shaded as in terrain.frag. They end in haze.
layout(binding = SLOT_FIRST_COVER) uniform sampler2D first_cover;

in vec3 at;
in vec2 slope;
in vec2 source;
in vec4 cover_lower_open_sun;
out vec4 colour;

// The visible share of the lower material, in surroundings_two.glsl; surroundings_one.glsl is for one material.
// `source` in cells; `added`: to the share there.
float lower_share(Place p, Detail d, vec2 source, float added);

// The share of cover, by pixel: vertices are farther apart than bare patches are wide.
float cover_here() {
    float depth = texture(first_cover, (source + 0.5) / vec2(frame.size.xy)).x;
    return clamp(cover_share(depth, slope) + cover_lower_open_sun.x, 0.0, 1.0);
}

void main() {
    vec3 ray = at - frame.eye.xyz;
    float forward = dot(ray, frame.ray_forward.xyz);
    Place p = place_at(at, ray / forward, forward, slope, cover_lower_open_sun.z);
    p.source = source;
    Detail d = detail_at(p);
    float thin = thinned(p, d, cover_here());
    float lower = lower_share(p, d, source, cover_lower_open_sun.y);
    float covered = clamp(thin / (0.015 + min(0.035 * p.footprint, 0.2) + 0.2 * p.footprint / frame.ground.x) + 0.5, 0.0, 1.0);
    vec3 lies = mix(frame.standing.rgb, frame.lower_standing.rgb, lower);
    vec4 turf = frame.material.w * mix(frame.turf, frame.lower_turf, lower);
    vec4 fine = fine_at(p, d, covered);
    Skin plants = plants_at(p, d, fine);
    Skin skin = blend(ground(p, d, fine, plants), blend(cover(lies, d, fine), grown(turf, d, fine, plants), turf.w), covered);

    vec3 normal = normalize(vec3(-slope - skin.rise, 1.0));
    float facing_sun = smoothstep(-0.05, 0.12, dot(vec3(-slope, 1.0), frame.sun.xyz));
    float in_sun = cover_lower_open_sun.w * facing_sun;
    if (kDated) in_sun *= through_clouds(at.xy);
    vec3 light = lit(vec3(1.0), normal, in_sun, p.open * clamp(skin.open, 0.0, 1.2));
    vec3 seen = through_air(skin.albedo * light + mirrored(p, normal, in_sun, skin.wet), at);
    vec2 middle = 0.5 * frame.ground.x * vec2(frame.size.xy - 1);
    vec2 out_of_grid = max(abs(at.xy - middle) - middle, 0.0);
    float sides = length(out_of_grid) / (2.0 * max(middle.x, middle.y));
    colour = vec4(mix(seen, frame.below.w * horizon(normalize(ray)), smoothstep(5.0, 8.8, sides)), 1.0);
}
