// Mountains around the block. Vertices of the grid's own ground are those that terrain.vert draws, so that there
// is no gap, whatever lies on them now.
layout(binding = SLOT_RELIEF) uniform sampler2D relief;
layout(binding = SLOT_LAYERS) uniform sampler2D layers;
layout(binding = SLOT_MIXTURE) uniform sampler2D mixture;

layout(location = 0) in vec3 position;      // m
layout(location = 1) in vec4 slope_source;  // slope; place on the grid, cells
layout(location = 2) in vec3 depth_open_on; // depth of the standing layer m, openness, 1: on the grid
layout(location = 3) in float sun;          // share of it that is seen

out vec3 at;         // m
out vec2 slope;
out vec4 cover_lower_open_sun;

void main() {
    at = position;
    slope = slope_source.xy;
    float cover = cover_share(depth_open_on.x, slope), open = depth_open_on.y;
    if (depth_open_on.z > 0.5) {
        ivec2 v = ivec2(position.xy / frame.ground.x + 0.5);
        vec4 here = texelFetch(relief, v, 0);
        at = vec3(vec2(v) * frame.ground.x, here.x);
        slope = here.yz;
        open = here.w;
        cover = texelFetch(layers, v, 0).x;
    }
    float lower = frame.lower_standing.w > 0.0 ? texture(mixture, (slope_source.zw + 0.5) / vec2(frame.size.xy)).r : 0.0;
    cover_lower_open_sun = vec4(cover, lower, open, sun);
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
