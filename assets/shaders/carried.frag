// What a flow carries: stone and trunks, with mud on them as far up as they were in the flow.
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec3 normal;
in vec4 body;
in vec2 light;
flat in float own;  // and whole: 0 stone, 1 bark, 2 wood, 3 roots
in vec3 air;
in vec3 kept;
out vec4 colour;

// The detail of its sides: small relief as in the ground's, by tiles so wide, m.
vec4 detail_on(vec3 place, float wide, float layer) {
    vec2 unrolled = vec2(place.x + 0.6 * place.z, place.y - 0.5 * place.z + 0.2 * place.x);
    vec4 t = texture(detail_texture, vec3(unrolled / wide + own, layer));
    return vec4(2.0 * t.xy - 1.0, t.zw);
}

void main() {
    vec4 rough = detail_on(body.xyz, 3.1, DETAIL_ROCK), soft = detail_on(body.xyz, 5.3, DETAIL_SOFT);
    vec4 fine = detail_on(body.xyz, 0.83, DETAIL_ROCK);
    vec3 n = normalize(normal), side = normalize(cross(n, vec3(0.36, 0.48, 0.80))), up = cross(n, side);
    float number = fract(own);
    vec3 bare = frame.rock.rgb * mix(0.75, 1.45, fract(7.3 * number)) * (0.40 + 0.6 * rough.z + 0.5 * fine.z) * mix(vec3(1.08, 1.0, 0.90), vec3(0.95, 1.0, 1.05), fract(13.7 * number));
    float line = 0.22 + 0.50 * fract(3.1 * number);  // of the mud on it, heights
    if (own >= 1.0) {
        bare = mix(vec3(0.105, 0.078, 0.055), vec3(0.165, 0.135, 0.105), number) * (0.5 + 1.0 * rough.z);
        line -= 0.15;
    }
    if (own >= 2.0) bare = vec3(0.40, 0.29, 0.17) * (0.6 + 0.7 * rough.z);
    if (own >= 3.0) bare = mix(vec3(0.060, 0.044, 0.030), frame.standing.rgb * 0.55, soft.z);
    float mud = clamp(smoothstep(line + 0.22, line - 0.10, body.w + 0.5 * (soft.z - 0.5)) + 0.55 * smoothstep(0.45, 0.65, soft.z) * step(0.4, number), 0.0, 1.0);
    mud *= 0.65 + 0.35 * rough.z;
    vec3 albedo = mix(bare, frame.standing.rgb * (0.75 + 0.35 * soft.z) * (1.0 - 0.30 * frame.rock.w), 0.85 * mud);
    vec2 relief = (0.8 * rough.xy + 0.55 * fine.xy) * (1.0 - 0.5 * mud) + 0.25 * soft.xy;
    n = normalize(n - relief.x * side - relief.y * up);
    colour = vec4(lit(albedo, n, light.x, light.y * (0.75 + 0.4 * rough.z)) * kept + air, 1.0);
}
