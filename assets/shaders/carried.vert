// What a flow carries: render/flow/carried_in_view.h has what a vertex holds.
layout(location = 0) in vec4 place;
layout(location = 1) in vec4 facing;
layout(location = 2) in vec4 within;

out vec3 normal;
out vec4 body;    // place in it, m; height above the surface by its size
out vec2 light;   // sunlit, open; 0 to 1
flat out float own;
out vec3 air;     // light of the air before it
out vec3 kept;    // share of the light behind that the air leaves

void main() {
    vec3 at = place.xyz;
    normal = facing.xyz;
    body = within;
    own = place.w;
    light = vec2(sunlit(at + vec3(0.0, 0.0, 0.3)) * through_clouds(at.xy), facing.w);
    vec3 dark = through_air(vec3(0.0), at);
    air = dark;
    kept = through_air(vec3(1.0), at) - dark;
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
