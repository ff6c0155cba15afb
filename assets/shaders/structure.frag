// Structures: boards, stone, steel, snow on roofs, lamps behind windows.
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec2 ground;
in vec3 light;
in vec3 air;
flat in int material;
flat in vec2 numbers;
in vec3 on_face;
in float muddy;
out vec4 colour;

// Lines every `apart` metres, 0 on a line and 1 between, which fade where they are thinner than a pixel.
float lines(float place, float apart, float pixel) {
    float t = abs(fract(place / apart) - 0.5) * 2.0;
    return mix(1.0, smoothstep(1.0, 0.8, t), clamp(1.3 - 2.5 * pixel / apart, 0.0, 1.0));
}

// Asphalt, mended here and there, with dirt along its edges and a line of dashes in the middle. `width`: of the road, m.
const float NARROWEST_PAVED = 5.0;
vec3 paved(vec2 place, float width, float pixel, vec4 soft, vec4 rock) {
    float from_middle = place.y - 0.5 * width, from_edge = 0.5 * width - abs(from_middle);
    vec3 albedo = vec3(0.092, 0.090, 0.089) * (0.82 + 0.22 * soft.z + 0.16 * rock.z);
    albedo *= mix(0.84, 1.0, smoothstep(0.55, 0.60, soft.w));
    float tracks = smoothstep(0.45, 0.1, abs(abs(fract(place.y / (0.5 * width)) - 0.5) - 0.25) * 0.5 * width);
    albedo *= 1.0 + 0.10 * tracks;
    albedo = mix(vec3(0.135, 0.115, 0.085) * (0.7 + 0.6 * rock.z), albedo, smoothstep(0.05, 0.5, from_edge - 0.5 * (rock.z - 0.5)));
    float thin = max(0.06, pixel), line = smoothstep(thin + 0.5 * pixel, thin - 0.5 * pixel, abs(from_middle)) * 0.06 / thin;
    float dash = smoothstep(0.0, pixel + 0.02, 1.5 - abs(mod(place.x, 9.0) - 4.5));
    return mix(albedo, vec3(0.42), 0.8 * line * dash * clamp(2.0 - 4.0 * pixel, 0.0, 1.0));
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
            albedo = mix(albedo, vec3(0.30, 0.28, 0.25), smoothstep(0.04 + 0.5 * pixel, 0.04 - 0.5 * pixel, abs(on_face.x)) * clamp(1.5 - 12.0 * pixel, 0.0, 1.0));
            lamp = step(0.04, abs(on_face.x)) * (1.0 - frame.cloud.w) * 0.13 * mix(frame.zenith.rgb, frame.away.rgb, 0.25 + 0.35 * numbers.y) + frame.cloud.w * step(0.4, numbers.y) * vec3(1.0, 0.50, 0.15) * (0.7 + 0.5 * numbers.y);
            break;
        case BUILT_STEEL: albedo = vec3(0.16, 0.17, 0.18); break;
        case BUILT_ROAD:
            // Wheels have worn packed snow down to the gravel, in two tracks of each lane.
            {
                float lane = abs(abs(fract(on_face.y / 2.9) - 0.5) - 0.25) * 2.9;  // m from the middle of a track
                float track = mix(0.45, smoothstep(0.50, 0.18, lane + 0.3 * (soft.z - 0.5)), clamp(1.5 - 2.0 * pixel, 0.0, 1.0));
                float worn = track * (0.45 + 0.9 * soft.z + 0.5 * (rock.z - 0.5)) + 0.5 * (rock.z - 0.4) * soft.w;
                vec3 gravel = vec3(0.165, 0.155, 0.145) * (0.6 + 0.7 * rock.z), packed_snow = frame.standing.rgb * (0.52 + 0.16 * soft.z + 0.12 * rock.z);
                albedo = mix(gravel * (1.0 - 0.3 * track), packed_snow, numbers.y * (1.0 - 0.85 * clamp(worn, 0.0, 1.0)));
                if (frame.season.w > 0.0 && numbers.x * ROAD_WIDEST > NARROWEST_PAVED)
                    albedo = mix(paved(on_face.xy, numbers.x * ROAD_WIDEST, pixel, soft, rock), albedo, numbers.y);
            }
            break;
        case BUILT_BANK: albedo *= 0.70 + 0.14 * soft.z + 0.20 * rock.z; break;  // thrown up with some of the road
        case BUILT_PLASTER:
            albedo = mix(vec3(0.50, 0.45, 0.36), vec3(0.56, 0.53, 0.49), numbers.x) * (0.86 + 0.2 * rock.z + 0.1 * soft.z);
            albedo *= mix(0.72, 1.0, smoothstep(0.0, 1.2, on_face.y + 0.6 * (rock.z - 0.4)));  // splashed at its foot
            break;
        case BUILT_TILE: albedo = vec3(0.155, 0.062, 0.040) * (0.7 + 0.6 * rock.z) * (0.6 + 0.4 * lines(on_face.y, 0.34, pixel)); break;
        case BUILT_CONCRETE: albedo = vec3(0.27, 0.262, 0.25) * (0.78 + 0.3 * rock.z + 0.12 * soft.z) * (0.86 + 0.14 * lines(on_face.y, 1.2, pixel)); break;
        case BUILT_GLASS:
            // The sky in it; bars of the frame between panes.
            albedo = vec3(0.15, 0.21, 0.235) * (0.75 + 0.7 * soft.z) * (0.35 + 0.65 * lines(on_face.x, 1.5, pixel)) * (0.5 + 0.5 * lines(on_face.y, 1.1, pixel));
            lamp = 0.35 * frame.cloud.w * vec3(1.0, 0.62, 0.28);
            break;
        case BUILT_BRICK: albedo = vec3(0.23, 0.098, 0.066) * (0.6 + 0.7 * rock.z) * (0.72 + 0.28 * lines(on_face.y, 0.16, pixel)); break;
        case BUILT_DARK: albedo = vec3(0.035, 0.024, 0.018); break;
    }
    albedo = mix(albedo, frame.standing.rgb * (0.55 + 0.5 * rock.z), muddy * smoothstep(0.62, 0.38, soft.z + 0.5 * (rock.z - 0.5)));
    colour = vec4(albedo * light + lamp + air, 1.0);
}
