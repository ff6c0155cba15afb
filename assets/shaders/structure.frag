// Structures: boards, stone, steel, snow on roofs, lamps behind windows.
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec2 ground;
in vec3 light;
in vec3 air;
flat in int material;
flat in vec2 numbers;
in vec3 on_face;
out vec4 colour;

// Lines every `apart` metres, 0 on a line and 1 between, which fade where they are thinner than a pixel.
float lines(float place, float apart, float pixel) {
    float t = abs(fract(place / apart) - 0.5) * 2.0;
    return mix(1.0, smoothstep(1.0, 0.8, t), clamp(1.3 - 2.5 * pixel / apart, 0.0, 1.0));
}

void main() {
    float pixel = on_face.z;
    vec4 soft = texture(detail_texture, vec3(ground / 23.0, DETAIL_SOFT));
    vec4 rock = texture(detail_texture, vec3(on_face.xy / 5.0, DETAIL_ROCK));
    vec3 albedo = frame.standing.rgb, lamp = vec3(0.0);
    switch (material) {
        case BUILT_WOOD:
            albedo = mix(vec3(0.070, 0.036, 0.020), vec3(0.145, 0.095, 0.060), numbers.x) * (0.75 + 0.5 * rock.z) * (0.55 + 0.45 * lines(on_face.y, 0.32, pixel));
            break;
        case BUILT_STONE: albedo = vec3(0.22, 0.205, 0.19) * (0.5 + rock.z); break;
        case BUILT_ROOF: albedo = vec3(0.085, 0.080, 0.078) * (0.7 + 0.6 * rock.z) * (0.7 + 0.3 * lines(on_face.y, 0.5, pixel)); break;
        case BUILT_WINDOW:
            albedo = vec3(0.03, 0.035, 0.045);
            lamp = frame.cloud.w * step(0.4, numbers.y) * vec3(1.0, 0.50, 0.15) * (0.7 + 0.5 * numbers.y);
            break;
        case BUILT_STEEL: albedo = vec3(0.16, 0.17, 0.18); break;
        case BUILT_ROAD:
            // Wheels have worn packed snow down to the gravel.
            albedo = mix(vec3(0.110, 0.104, 0.096) * (0.6 + 0.7 * rock.z), 0.55 * frame.standing.rgb, numbers.y * smoothstep(0.42, 0.75, soft.z + 0.35 * (rock.z - 0.5)));
            break;
        case BUILT_BANK: albedo *= 0.82 + 0.22 * rock.z; break;
        case BUILT_DARK: albedo = vec3(0.035, 0.024, 0.018); break;
    }
    colour = vec4(albedo * light + lamp + air, 1.0);
}
