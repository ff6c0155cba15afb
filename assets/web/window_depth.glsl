// The reversed depth of the scene at a sample, as scene_depth.glsl has it, from a depth that WebGL has stretched:
// ½ + ½ · near plane / distance.
layout(binding = SLOT_SCENE_DEPTH) uniform sampler2D scene_depth;

float scene_depth_at(ivec2 at) { return 2.0 * texelFetch(scene_depth, at, 0).r - 1.0; }
