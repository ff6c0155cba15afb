// Mountains around the block: the ground of terrain.frag with half of its detail, because they are far away. They
// end in haze.
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec3 at;
in vec2 slope;
in vec4 cover_lower_open_sun;
out vec4 colour;

vec4 detail(float kind, float scale, float c, float s, float footprint) {
    mat2 rotation = mat2(c, s, -s, c);
    float repeats = frame.eye.w * scale;
    float level = log2(footprint * repeats * float(textureSize(detail_texture, 0).x)) - 0.4;
    vec4 t = textureLod(detail_texture, vec3(rotation * at.xy * repeats + c, kind), level);
    t.xy = (t.xy * 2.0 - 1.0) * rotation;
    return mix(vec4(0.0, 0.0, 0.5, 0.5), t, frame.haze.w);
}

void main() {
    vec3 ray = at - frame.eye.xyz;
    float facing = dot(vec3(-slope, 1.0), ray) / sqrt((1.0 + dot(slope, slope)) * dot(ray, ray));
    float footprint = dot(ray, frame.ray_forward.xyz) * frame.material.y * inversesqrt(clamp(-facing, 0.06, 1.0));
    vec4 broad = detail(DETAIL_SOFT, 0.31, 0.921, 0.389, footprint), soft = detail(DETAIL_SOFT, 1.9, 0.267, 0.964, footprint);
    vec4 rock = detail(DETAIL_ROCK, 0.8, -0.588, 0.809, footprint);

    float altitude = (at.z - frame.ground.z) / (frame.ground.w - frame.ground.z);
    float bare = smoothstep(0.50, 0.95, length(slope) + 0.5 * (broad.z - 0.5) + 0.35 * (rock.z - 0.5) +
                                            0.35 * smoothstep(0.45, 1.0, altitude) * frame.haze.w);
    vec3 grass = frame.meadow.rgb * mix(vec3(0.55, 0.68, 0.62), vec3(1.55, 1.32, 1.2), broad.w) * (0.55 + 0.9 * soft.z);
    vec3 stone = frame.rock.rgb * (0.62 + 0.75 * rock.z) * mix(vec3(1.08, 1.0, 0.90), vec3(0.93, 1.0, 1.08), broad.w);
    vec3 albedo = mix(grass, stone, bare);
    vec2 rise = mix(0.25 * soft.xy, 0.8 * rock.xy, bare);

    float thin = cover_lower_open_sun.x - 0.30 * (rock.z - 0.5) * length(slope);
    float covered = clamp((thin - 0.5) / (0.06 + footprint / frame.ground.x) + 0.5, 0.0, 1.0);
    vec3 lies = mix(frame.standing.rgb, frame.lower_standing.rgb, cover_lower_open_sun.y);
    vec4 turf = frame.material.w * mix(frame.turf, frame.lower_turf, cover_lower_open_sun.y);
    vec3 grown = turf.rgb / max(turf.w, 1e-3) * mix(vec3(0.65, 0.75, 0.70), vec3(1.50, 1.25, 1.10), broad.w) * (0.80 + 0.45 * soft.z);
    albedo = mix(albedo, mix(lies, grown, turf.w), covered);
    rise = mix(rise, 0.15 * soft.xy + 0.14 * broad.xy, covered);

    vec3 normal = normalize(vec3(-slope - rise, 1.0));
    float facing_sun = smoothstep(-0.05, 0.12, dot(vec3(-slope, 1.0), frame.sun.xyz));
    vec3 seen = through_air(albedo * lit(vec3(1.0), normal, cover_lower_open_sun.w * facing_sun, cover_lower_open_sun.z), at);
    vec2 middle = 0.5 * frame.ground.x * vec2(frame.size.xy - 1);
    vec2 out_of_grid = max(abs(at.xy - middle) - middle, 0.0);
    float gone = smoothstep(5.0, 8.8, length(out_of_grid) / (frame.ground.x * float(max(frame.size.x, frame.size.y) - 1)));
    colour = vec4(mix(seen, frame.below.w * horizon(ray / length(ray)), gone), 1.0);
}
