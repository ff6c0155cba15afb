// The reversed depth of the scene at a sample: 1 at the near plane, 0 at infinity.
layout(binding = SLOT_SCENE_DEPTH) uniform sampler2D scene_depth;

float scene_depth_at(ivec2 at) { return texelFetch(scene_depth, at, 0).r; }
