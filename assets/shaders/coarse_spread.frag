// Spreads the colours of every second sample along x and y over the samples between, see coarse_ground.h: each is the mean
// of those around it, or at an edge of the ground the one that is most like it in depth.
layout(binding = SLOT_COLOUR) uniform sampler2D coarse_colour;  // filtered
layout(binding = SLOT_COARSE_DEPTH) uniform sampler2D coarse_depth;

out vec4 colour;

// Draws marks on the ground, in marks.glsl or marks_none.glsl.
vec3 marked(vec3 seen, Place p, vec3 light);

const float kAlike = 0.04;  // of the depth: how much two samples of one slope may differ

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = scene_depth_at(at);
    vec2 size = vec2(textureSize(coarse_depth, 0)), first = floor(0.5 * vec2(at)), between = first + 0.5 + 0.5 * vec2(at & 1);
    vec4 apart = abs(textureGather(coarse_depth, (first + 1.0) / size) - depth);  // above, its right, right, here
    float least = min(min(apart.x, apart.y), min(apart.z, apart.w)), most = max(max(apart.x, apart.y), max(apart.z, apart.w));
    vec2 nearest = apart.w == least ? vec2(0.0) : apart.z == least ? vec2(1.0, 0.0) : apart.x == least ? vec2(0.0, 1.0) : vec2(1.0);
    vec3 seen = textureLod(coarse_colour, (most > kAlike * depth ? first + 0.5 + nearest : between) / size, 0.0).rgb;
    colour = vec4(marked(seen, find_place(depth), vec3(1.0)), 1.0);
}
