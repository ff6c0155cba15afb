// Depth of the ground for every second sample along x and y, see coarse_ground.h. Where that one shows none, but one
// beside it does, it is that one's, so that there is a colour for it.
void main() {
    ivec2 at = 2 * ivec2(gl_FragCoord.xy), last = textureSize(scene_depth, 0) - 1;
    float here = scene_depth_at(at);
    float right = scene_depth_at(min(at + ivec2(1, 0), last)), above = scene_depth_at(min(at + ivec2(0, 1), last)),
          beyond = scene_depth_at(min(at + 1, last));
    gl_FragDepth = here > 0.0 ? here : max(max(right, above), beyond);
}
