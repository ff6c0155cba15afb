// Walls: the sides of the block of terrain. Earth in layers, darker downward, turf on top.
layout(binding = SLOT_SITE) uniform usampler2D site;
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

in vec3 at;
in float below_m;
out vec4 colour;

const float kOpen = 1.6;  // walls stand free and receive light from all sides

// Share of ground at a place, 0 to 1. Its gradient gives the direction of a wall, because the faces along
// no-data zigzag with the grid.
float ground(vec2 cell) {
    vec2 inside = clamp(min(cell, vec2(frame.size.xy - 1) - cell) + 0.5, 0.0, 1.0);
    uvec4 sites = textureGather(site, (floor(cell) + 1.0) / vec2(frame.size.xy));  // counterclockwise from the upper left
    vec4 is_ground = vec4(notEqual(sites, uvec4(SITE_DRAIN)));
    vec2 between = fract(cell);
    vec2 row = mix(is_ground.wx, is_ground.zy, between.x);
    return inside.x * inside.y * mix(row.x, row.y, between.y);
}

void main() {
    float tall = frame.ground.w - frame.ground.y;
    vec2 along_wall = vec2(at.x + at.y, 2.0 * at.z) / 120.0;  // a tile is 120 m wide
    vec4 rock = texture(detail_texture, vec3(along_wall, DETAIL_ROCK));
    // Layers of earth, wavy and uneven. A smoothed sawtooth is as good as a sine and much cheaper.
    float layers = abs(2.0 * fract(9.0 * at.z / tall + 1.2 * rock.w) - 1.0);
    vec3 earth = mix(frame.rock.rgb, vec3(0.30, 0.21, 0.14), 0.75);
    earth *= 0.70 + 0.25 * layers * layers * (3.0 - 2.0 * layers) + 0.5 * (rock.z - 0.5);
    earth *= mix(0.55, 1.0, clamp((at.z - frame.ground.y) / tall * 2.5, 0.0, 1.0));
    earth *= 1.0 - 0.45 * (1.0 - smoothstep(0.0, 0.014 * tall, below_m));  // turf
    vec2 cell = at.xy / frame.ground.x;
    vec2 outward = vec2(ground(cell - vec2(1.5, 0.0)) - ground(cell + vec2(1.5, 0.0)),
                        ground(cell - vec2(0.0, 1.5)) - ground(cell + vec2(0.0, 1.5)));
    vec3 normal = vec3(outward / max(length(outward), 1e-4), 0.0);
    float sun = sunlit(at + normal * (1.5 * frame.ground.x));  // in front of the wall, so that the surface above casts no shadow on it
    colour = vec4(through_air(lit(earth, normal, sun, kOpen), at), 1.0);
}
