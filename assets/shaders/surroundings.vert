// Mountains around the block. Vertices of the grid's own ground are those that terrain.vert draws, so that there
// is no gap, whatever lies on them now.
layout(binding = SLOT_RELIEF) uniform sampler2D relief;
layout(binding = SLOT_LAYERS) uniform sampler2D layers;
layout(binding = SLOT_MIXTURE) uniform sampler2D mixture;
layout(binding = SLOT_FIRST_COVER) uniform sampler2D first_cover;

layout(location = 0) in vec3 position;      // m
layout(location = 1) in vec4 slope_source;  // slope; place on the grid, cells
layout(location = 2) in vec4 cover_open_on; // added to the cover of the source: depth m, share of the lower material; openness, 1: on the grid
layout(location = 3) in float sun;          // share of it that is seen

out vec3 at;         // m
out vec2 slope;
out vec2 source;     // cells
out vec4 cover_lower_open_sun;  // the first two: added to the shares at the source

void main() {
    at = position;
    slope = slope_source.xy;
    source = slope_source.zw;
    vec2 first = textureLod(first_cover, (source + 0.5) / vec2(frame.size.xy), 0.0).xy;
    float depth = max(first.x + cover_open_on.x, 0.0), open = cover_open_on.z;
    vec2 cover = vec2(cover_share(depth, slope), first.y + cover_open_on.y);
    if (cover_open_on.w > 0.5) {
        ivec2 v = ivec2(position.xy / frame.ground.x + 0.5);
        vec4 here = texelFetch(relief, v, 0);
        at = vec3(vec2(v) * frame.ground.x, here.x);
        slope = here.yz;
        open = here.w;
        cover = vec2(texelFetch(layers, v, 0).x, frame.lower_standing.w > 0.0 ? texelFetch(mixture, v, 0).r : 0.0);
    }
    cover_lower_open_sun = vec4(cover - vec2(cover_share(first.x, slope), first.y), open, sun);
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
