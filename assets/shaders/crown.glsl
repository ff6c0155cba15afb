// The crown of a slab, and its flanks.
layout(binding = SLOT_UNDISTURBED) uniform sampler2D undisturbed;

// −1 to 1, of a square of the ground `size` m wide, turned out of the grid.
float of_block(vec2 at, float size) {
    ivec2 cell = ivec2(floor(mat2(0.829, 0.559, -0.559, 0.829) * at / size));
    uint h = (uint(cell.x) * 0x9E3779B1u) ^ (uint(cell.y) * 0x85EBCA77u);
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    return float(h >> 16) / 32768.0 - 1.0;
}

// A wall stands where the standing layer changes within a cell or two:
//
//     untouched ───────┐ upper edge, broken in blocks a few metres wide
//                      │ face, as high as the layer was deep
//                      └─────── bed
//
// The spline makes a slope of two cells of that; a vertex beside the place is on one side or the other.
Crown crown_at(inout Smooth layer, Place p, Detail d) {
    vec2 size = vec2(frame.size.xy), here = (p.at.xy / frame.ground.x + 0.5) / size, beside = 1.1 / size;
    vec4 east = texture(layers, vec2(here.x + beside.x, here.y)), west = texture(layers, vec2(here.x - beside.x, here.y));
    vec4 north = texture(layers, vec2(here.x, here.y + beside.y)), south = texture(layers, vec2(here.x, here.y - beside.y));
    vec4 above = max(max(east, west), max(north, south)), below = min(min(east, west), min(north, south));
    vec2 along = vec2(east.w - west.w, north.w - south.w);
    float cell = frame.ground.x, step = above.w - below.w;
    Crown c;
    c.up = along * inversesqrt(dot(along, along) + 1e-8);
    // Below it the layer is gone: the edge of a deposit on ground that is whole is no wall.
    c.near = smoothstep(0.20, 0.32, step) * smoothstep(0.22, 0.36, above.w) * smoothstep(0.41, 0.37, below.w) * frame.haze.w;
    float broken = min(0.05 * cell, 0.6) * (of_block(p.at.xy, 7.3) + 0.5 * of_block(p.at.xy, 2.9)) + 0.4 * (d.clumps.z - 0.59);
    c.side = 1.5 * (layer.value.w - 0.5 * (above.w + below.w)) / max(step, 0.05) * cell + broken;
    layer.value.xw = mix(layer.value.xw, c.side < 0.0 ? below.xw : above.xw, c.near);
    layer.along_x.x *= 1.0 - c.near;
    layer.along_y.x *= 1.0 - c.near;

    c.height_m = min(texture(undisturbed, here + c.up / size).r, 3.0);
    // In plan half as wide again as high, so that it is seen from above too, and never narrower than a pixel: farther
    // away it is fainter instead.
    float wide = max(1.5 * c.height_m, p.footprint);
    c.shown = c.near * smoothstep(0.36, 0.46, above.w) * smoothstep(-wide - 0.5 * p.footprint, -wide + 0.5 * p.footprint, c.side) * smoothstep(0.5 * p.footprint, -0.5 * p.footprint, c.side) * min(1.5 * c.height_m / wide, 1.0);
    return c;
}

Skin wall(Skin skin, Crown crown, vec3 lies, Detail d, inout Place p) {
    // A dark line at its foot, and beyond it the shade of the wall.
    float wide = max(1.5 * crown.height_m, p.footprint), out_m = -crown.side - wide;
    float foot = crown.near * smoothstep(-0.2, 0.1, out_m) * smoothstep(1.5 * crown.height_m + 0.5 * p.footprint, 0.0, out_m) * min(1.5 * crown.height_m / wide, 1.0);
    skin.open *= 1.0 - 0.35 * foot;
    skin.albedo *= 1.0 - 0.35 * foot * smoothstep(0.35 + p.footprint, 0.0, out_m);

    // The face cuts the layers that storms have left: level and a few centimetres to decimetres thick.
    float depth_m = -crown.side / wide * crown.height_m + 0.05 * d.clumps.z;
    vec2 strata = abs(fract(depth_m * vec2(2.3, 7.1) + vec2(0.0, 0.4 * d.soft.z)) * 2.0 - 1.0) - 0.5;
    strata *= clamp(1.2 - p.footprint * vec2(2.0, 6.0), 0.0, 1.0);
    Skin face = Skin(lies * mix(vec3(1.0), vec3(0.90, 0.93, 0.97), smoothstep(0.1, 0.9, depth_m)) * (0.96 + 0.12 * strata.x + 0.08 * strata.y),
                     0.25 * d.rock.xy + 0.1 * d.clumps.xy, 0.85, 0.0);
    if (kDated && lies.g < 0.5) {  // soil: roots under the turf, then ever paler and stonier
        float roots = smoothstep(0.30, 0.05, depth_m), subsoil = smoothstep(0.5, 1.3, depth_m + 0.5 * (d.soft.z - 0.5));
        face.albedo = mix(lies * 0.75, mix(lies, vec3(0.26, 0.19, 0.115), 0.7), subsoil) * (0.70 + 0.35 * d.clumps.z + 0.3 * strata.y);
        face.albedo = mix(face.albedo, lies * vec3(0.42, 0.38, 0.32), 0.7 * roots);
        face.albedo = mix(face.albedo, frame.rock.rgb, 0.8 * subsoil * smoothstep(0.55, 0.70, d.rock.z));
        face.rise = 0.5 * d.rock.xy + 0.4 * d.clumps.xy;
    }
    p.slope = mix(p.slope, 2.2 * crown.up, crown.shown);
    skin = blend(skin, face, crown.shown);
    return skin;
}
