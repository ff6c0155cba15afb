// Powder, its reach: the farthest of the places that a coarse pixel shows, so that no cloud ends before a valley
// because a ridge is beside it.
out float reach;

const float kSky = 60000.0;  // m

void main() {
    int across = powder.divisor.x - 1;
    ivec2 first = ivec2(gl_FragCoord.xy) * powder.divisor.x, last = textureSize(scene_depth, 0) - 1;
    float farthest = min(min(scene_depth_at(min(first, last)), scene_depth_at(min(first + ivec2(across, 0), last))),
                         min(scene_depth_at(min(first + ivec2(0, across), last)), scene_depth_at(min(first + across, last))));
    reach = min(frame.ray_forward.w / max(farthest, 1e-9), kSky);
}
