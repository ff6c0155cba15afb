// Powder, its reach: the farthest of the places that a coarse pixel shows, so that no cloud ends before a valley
// because a ridge is beside it.
layout(binding = SLOT_SCENE_DEPTH) uniform sampler2D scene_depth;

out float reach;

const float kSky = 60000.0;  // m

void main() {
    int across = powder.divisor.x - 1;
    ivec2 first = ivec2(gl_FragCoord.xy) * powder.divisor.x, last = textureSize(scene_depth, 0) - 1;
    float farthest = min(min(texelFetch(scene_depth, min(first, last), 0).r,
                             texelFetch(scene_depth, min(first + ivec2(across, 0), last), 0).r),
                         min(texelFetch(scene_depth, min(first + ivec2(0, across), last), 0).r,
                             texelFetch(scene_depth, min(first + across, last), 0).r));
    reach = min(frame.ray_forward.w / max(farthest, 1e-9), kSky);
}
