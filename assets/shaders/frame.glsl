// Uniforms of the frame for every pass; they match render/view/frame_block.h. Space: metres, x east and y north
// from vertex (0, 0), z above datum.
layout(std140, binding = SLOT_FRAME) uniform Frame {
    mat4 clip_from_world;   // reversed depth: 1 at the near plane, 0 at infinity
    vec4 eye;               // xyz; w: 1 / width of a tile of the broadest detail, 1/m
    vec4 ray_forward;       // unit vector along the view; w: near plane, m
    vec4 ray_right;         // view rays: middle + x · right + y · up, x and y in −1 to 1
    vec4 ray_up;            // w: half the height of the whole image at a distance of 1
    vec4 ray_middle;        // is forward, unless the frame is a part of an image
    vec4 sun;               // xyz: unit vector to the light that casts shadows, sun or moon; w: tangent of its elevation
    vec4 ground;            // cell m, base of the block m, lowest and highest bedrock m
    ivec4 size;             // vertices along x and y; rays and rows of the sun sweep
    vec4 sweep;             // shear (cells per row), first ray (cells), fall of the light per row (m), 1: rows are columns
    vec4 haze;              // 1 / its length high up 1/m; height of the valley m; 1: sweep starts at the last row; detail 0 to 1
    vec4 rock;              // w: how much flowing material shines, 0 to 1
    vec4 meadow;            // w: old snow on gentle ground, m
    vec4 standing;          // w: depth that hides the ground, m
    vec4 rolling;           // w: depth at which it is drawn, m
    vec4 lower_standing;    // of the lower material; w: 1 in a world of two
    vec4 lower_rolling;     // w: levels by which this image is coarser than a finished one, 0 to 1.5
    vec4 turf;              // of the standing layer where it never changed; w: 1 if there is any
    vec4 lower_turf;        // of the lower material
    vec4 material;          // roughness 0 to 1; height of a sample at a distance of 1; samples along the edge of a pixel; 1: first depth is known
    vec4 beyond;            // of the rough heights around the block: place of vertex (0, 0) m, cell m; 1: there are any
    vec4 ring;              // centre m, radius m; 1: is drawn
    vec4 ring_colour;       // linear light
    vec4 outline;           // middles of its ends, m
    vec4 outline_colour;    // linear light; w: half its width, m, below 0: with a front; 0: none
    vec4 contours;          // lines per metre of height, 0: none; line, counted from a heavy one, at z = 0; 1: the outline of an extent is drawn
    vec4 flow;              // texture tiles per m; where it is drawn: FLOW_*; 0, 0
    vec4 flow_tint;         // factor on the texture's colours; 0
    ivec4 overlay;          // OVERLAY_*, 0: none; stops of its legend; 1: they are steps; number of the probability, without an overlay 1: soil is wet where plants have a date
    vec4 season;            // of grass: green 0 to 1; of trees: leaves 0 to 1, turned 0 to 1; 1: plants are as on a day of the year
    vec4 density;           // of the upper and the lower material, kg/m³, 0: unknown; 0, 0
    vec4 stops[MOST_STOPS]; // colour in sRGB; w: value
    vec4 lamp;              // light of sun or moon on a surface that faces it; w: contrast of openness 0 to 1. Linear, as all below
    vec4 above;             // light from the open sky; w: share of stars 0 to 1
    vec4 below;             // light from the ground; w: brightness of haze beside the horizon
    vec4 toward;            // sky at the horizon below the sun; w: x of the horizontal unit vector to the sun
    vec4 away;              // sky at the horizon opposite; w: its y
    vec4 zenith;            // sky at the zenith; w: how much brighter the sky is toward the sun than overhead, below 0 at night: toward the moon
    vec4 glow;              // air round the lamp; w: brightness of its disc
    vec4 cloud;             // thin cloud; w: lamps behind windows, 0 to 1
    vec4 disc;              // xyz: unit vector to the lamp in the sky; w: cosine of its radius
} frame;
